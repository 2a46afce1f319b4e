#pragma once

#include <string>
#include <string_view>

namespace frond {

/// A text as one word of a POSIX shell, in single quotes.
std::string shell_quoted(std::string_view text);

/// A text as it is written in build.ninja, as a path or as the value of a variable. Ninja has no way to write
/// a line break: one becomes a blank.
std::string ninja_escaped(std::string_view text);

/// A text as a JSON string with its quotes. UTF-8 passes as it is.
std::string json_quoted(std::string_view text);

}  // namespace frond
