#include <algorithm>
#include <cmath>

#include "images/raster.h"

// Apart from what reads and writes PNG, for the page that has no library for it.

namespace frond {

std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255));
}

}  // namespace frond
