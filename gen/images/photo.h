#pragma once

#include <cstdint>
#include <string_view>

#include "core/result.h"
#include "images/raster.h"

namespace frond {

/// Reads a PNG file that a person made of a photograph: 16 to 4096 pixels a side.
Result<Raster> read_photo(std::string_view png);

/// The linear brightness of a channel of a picture.
float linear(std::uint8_t channel);

}  // namespace frond
