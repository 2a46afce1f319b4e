#pragma once

#include <vector>

#include "core/seed.h"
#include "geometry/plot.h"
#include "model/surface.h"

namespace frond {

/// Hilly land about the origin, and a path through it.
struct TerrainShape {
  double size = 160;      ///< metres, of the square that is sown
  double hills = 8;       ///< metres, from valley to top
  double hill_size = 70;  ///< metres from hill to hill
  double rough = 0.4;     ///< 0 rolling .. 1 broken
  PathShape path;
};

}  // namespace frond
