#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace frond {

/// Bytes of the character (code point) that begins the text; 0 where none does: the text is empty or does not
/// begin with UTF-8. Overlong forms and surrogates are none.
std::size_t character_size(std::string_view text);

/// Offset of the first byte that is not UTF-8.
std::optional<std::size_t> invalid_utf8(std::string_view text);

}  // namespace frond
