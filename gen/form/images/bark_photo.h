#pragma once

#include <string_view>

#include "core/result.h"
#include "core/vec.h"
#include "images/raster.h"

namespace frond {

/// A photograph of bark as a colour picture that tiles in both directions: what is brighter or darker over a
/// large part of it is evened out, and its edges fade into what lies half a picture away. Its mean colour
/// stays. Reads a picture as read_photo() does.
Result<Raster> read_bark_photo(std::string_view bytes);

/// A tiling picture in another size.
Raster resized_tile(const Raster& tile, int width, int height);

/// A tile with another mean colour: each channel as much brighter or darker everywhere.
Raster tinted_tile(const Raster& tile, Color mean);

/// Heights, 0 deep .. 1 high, that its brightness suggests: furrows are dark.
Grid tile_heights(const Raster& tile);

}  // namespace frond
