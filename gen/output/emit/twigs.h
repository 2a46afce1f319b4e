#pragma once

#include <string>

#include "core/text.h"
#include "draw/draw_list.h"
#include "emit/pov.h"

namespace frond {

/// Writes the twigs of a plant: declares each of the palette, and places them in one union for each look.
/// `index` is the number of the plant's first skin. Gives how many unions there are.
std::size_t write_palette(const PovSpace& space, const DrawList& drawn, std::size_t index, const Out& out);

/// What must be included where there are twigs of a palette.
inline constexpr std::string_view kTwigInclude = "#include \"frond_twig.inc\"\n";

}  // namespace frond
