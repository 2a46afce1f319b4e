#pragma once

#include <string>
#include <string_view>

#include "preset/value.h"

namespace frond {

/// Maximum nesting depth of lists and objects.
inline constexpr int kDeepestNesting = 100;

/// A parsed text.
struct Document {
  Value root;
};

/// Reads JSON (RFC 8259) with `//` and `/* */` comments. Other extensions are refused with their position:
/// trailing commas, duplicate names, invalid UTF-8, numbers beyond double precision. A byte order mark is
/// skipped. Messages call the text `file_name`.
Result<Document> parse_json(std::string_view text, std::string_view file_name);

/// The value as JSON on one line, identical on all machines: members in their order, the shortest digits that
/// read back as the same number.
std::string serialize(const Value& value);

/// The value as JSON formatted for people: indented, short parts on one line of up to `width` characters.
std::string serialize_pretty(const Value& value, std::size_t width = 110);

}  // namespace frond
