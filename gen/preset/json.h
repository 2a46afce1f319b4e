#pragma once

#include <string>
#include <string_view>

#include "preset/value.h"

namespace frond {

/// Lists and objects may stand inside one another so deep; what goes deeper is refused.
inline constexpr int kDeepestNesting = 100;

/// A text that was read.
struct Document {
  Value root;
};

/// Reads JSON (RFC 8259) with `//` and `/* */` comments. Everything else beyond the standard is refused, with
/// its place: trailing commas, a name twice in an object, text that is not UTF-8, numbers beyond double
/// precision. A byte order mark is passed over. `file_name` is what messages call the text.
Result<Document> parse_json(std::string_view text, std::string_view file_name);

/// The value as JSON on one line, the same text for the same value wherever it is made: members in their
/// order, the shortest digits that read back as the same number.
std::string serialize(const Value& value);

/// The same for people: indented, what fits on a line of `width` on one line.
std::string serialize_pretty(const Value& value, std::size_t width = 110);

}  // namespace frond
