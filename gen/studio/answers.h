#pragma once

#include <set>
#include <string>

#include "studio/documents.h"

namespace frond {

/// An answer to the page: JSON, or a packet.
struct Answer {
  int status = 200;
  Json json;
  std::string packet;  ///< where not empty, in place of the JSON
};

/// That a preset is wrong.
Answer wrong(const Errors& errors, const Errors& notes = {});

/// All that a scene follows from, and whose it is.
std::string key_of(const Doc& doc, const Preset& preset);

/// The whole numbers of a list of a question; none where there is no such list.
std::set<std::size_t> numbers(const Json& question, const char* name);

/// `[{"symbol", "doc"}, …]` of all symbols of the turtle.
Json symbols_json();

}  // namespace frond
