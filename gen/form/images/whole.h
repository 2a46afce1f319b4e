#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace frond {

/// Width and height of a complete PNG file: its signature, every chunk with a correct checksum, the end and
/// nothing after it. Nothing if it is truncated, damaged or no PNG. The pixels are not decompressed.
std::optional<std::array<int, 2>> whole_png(std::string_view bytes);

/// The four bytes there as a number, the first the highest.
std::uint32_t big_endian_at(std::string_view bytes, std::size_t at);

}  // namespace frond
