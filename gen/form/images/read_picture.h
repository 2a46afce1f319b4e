#pragma once

#include <string_view>

#include "core/result.h"
#include "images/raster.h"

namespace frond {

/// Reads a picture that a person made, of a kind that is told by its first bytes: PNG, JPEG or WebP, as grey,
/// colour or colour with opacity; at most 16384 pixels a side. A JPEG is turned as the camera was held, which
/// its EXIF tells. An error says what the file is and what was expected.
Result<Raster> read_picture(std::string_view bytes);

/// Reads a picture as read_picture() does, but leaves its pixels as they are stored, which is how texture
/// coordinates of a mesh count them.
Result<Raster> read_texture(std::string_view bytes);

/// Whether bytes begin as those of a picture that is read.
bool is_picture(std::string_view bytes);

}  // namespace frond
