#pragma once

#include <string>
#include <string_view>

namespace frond {

/// A text as one word of a POSIX shell, in single quotes.
std::string shell_quoted(std::string_view text);

/// A text as a path in a build line of build.ninja. Ninja cannot represent a line break or a `|` in a path: a
/// line break becomes a blank, and a `|` must come from a variable.
std::string ninja_path(std::string_view text);

/// A text as the value of a variable of build.ninja. A line break becomes a blank.
std::string ninja_value(std::string_view text);

/// A text as a JSON string with its quotes. UTF-8 is kept; bytes that are none become U+FFFD.
std::string json_quoted(std::string_view text);

}  // namespace frond
