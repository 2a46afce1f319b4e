#pragma once

#include <string>
#include <string_view>

namespace frond {

/// A text as one word of a POSIX shell, in single quotes.
std::string shell_quoted(std::string_view text);

/// A text as a path of a build line of build.ninja. Ninja has no way to write a line break, nor a `|` in a
/// path: a line break becomes a blank, and a `|` must come out of a variable.
std::string ninja_path(std::string_view text);

/// A text as the value of a variable of build.ninja. A line break becomes a blank.
std::string ninja_value(std::string_view text);

/// A text as a JSON string with its quotes. UTF-8 passes as it is.
std::string json_quoted(std::string_view text);

}  // namespace frond
