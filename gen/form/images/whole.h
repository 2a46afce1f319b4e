#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace frond {

/// Width and height of a complete PNG file: its signature, every chunk with a correct checksum, the end and
/// nothing after it. Nothing if it is truncated, damaged or no PNG. The pixels are not decompressed.
std::optional<std::array<int, 2>> whole_png(std::string_view bytes);

}  // namespace frond
