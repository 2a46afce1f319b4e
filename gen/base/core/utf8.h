#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace frond {

/// Length in bytes of the UTF-8 character (code point) at the start of the text; 0 where the text is empty or
/// does not begin with valid UTF-8. Overlong forms and surrogates are invalid.
std::size_t character_size(std::string_view text);

/// The number of a character that is valid UTF-8.
char32_t code_of(std::string_view character);

/// Appends the character of a number.
void append_utf8(std::string& text, char32_t code);

/// Offset of the first byte that is not valid UTF-8.
std::optional<std::size_t> invalid_utf8(std::string_view text);

}  // namespace frond
