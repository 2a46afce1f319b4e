#pragma once

#include <cstdint>
#include <string_view>

#include "core/result.h"
#include "images/raster.h"

namespace frond {

/// Reads a photograph, see read_picture(): 16 to 4096 pixels a side.
Result<Raster> read_photo(std::string_view bytes);

/// The linear brightness of a channel of a picture.
float linear(std::uint8_t channel);

}  // namespace frond
