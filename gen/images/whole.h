#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace frond {

/// Width and height of a PNG file that is whole: its signature, every chunk with the right sum, the end and
/// nothing after it. Nothing where it is cut off, damaged or no PNG. The pixels are not unpacked.
std::optional<std::array<int, 2>> whole_png(std::string_view bytes);

}  // namespace frond
