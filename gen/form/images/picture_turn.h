#pragma once

#include <string_view>

#include "images/raster.h"

namespace frond {

/// How a camera was held as it took a JPEG, as its EXIF tells (tag 0x0112): 1 upright .. 8; 1 where it does
/// not tell.
int jpeg_turn(std::string_view bytes);
/// How a camera was held as it took a WebP, in the numbers of jpeg_turn(); 1 where its EXIF does not tell.
int webp_turn(std::string_view bytes);

/// A picture turned upright; `turn` tells how its camera was held, in the numbers of jpeg_turn().
Raster turned(const Raster& from, int turn);

}  // namespace frond
