#pragma once

#include <string>
#include <string_view>

namespace frond {

/// A text file of any system as lines that end by newlines: without a byte order mark, with CRLF and CR as
/// newlines, up to the Ctrl-Z that ends a text of DOS. UTF-16 with its mark becomes UTF-8.
std::string plain_text(std::string_view bytes);

/// Without blanks, tabs and ends of lines at both its ends.
std::string_view trim(std::string_view text);

/// Whether a file's name ends so, in upper or lower case; `ending` in lower case.
bool has_ending(std::string_view name, std::string_view ending);

}  // namespace frond
