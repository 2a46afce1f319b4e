#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "preset/value.h"

namespace frond {

class Reader;

/// Named lists of colours at the top of a preset: {"palettes": {"autumn": ["#c8641e", "goldenrod"]}}.
struct Palettes {
  std::vector<std::string> names;
};

inline constexpr std::string_view kPalettesSchema = R"({"type": "object", "additionalProperties":
  {"type": "array", "minItems": 1, "items": {"anyOf": [{"type": "string"}, {"type": "array"}]}}})";

/// Reads an object of lists of colours; notes what is no colour.
bool read_palettes(Reader& reader, const Value& value, Palettes& palettes);

/// Puts the colours of the document's palettes in place of what names them, in its scene, defaults and
/// organisms: "palette:autumn/0" is the first colour, and "palette:autumn" all of them in a list, or the only
/// one. Gives the names of no palette, and places beyond the end of one.
Errors use_palettes(Value& root);

}  // namespace frond
