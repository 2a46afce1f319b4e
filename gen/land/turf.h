#pragma once

#include "core/seed.h"
#include "model/surface.h"

namespace frond {

/// Grass on a square metre or less.
struct TurfShape {
  double side = 0.5;     ///< metres, of the square patch about the origin
  double blade = 0.1;    ///< metres, length of a blade
  double density = 900;  ///< blades a square metre
  double flowers = 0;    ///< share of the blades that bear a flower instead
};

/// A patch of grass: blades, and the heads of the flowers among them. `uv`: u from root to tip (of a flower
/// head: from heart to rim), v a number of the blade's own.
struct Turf {
  Surface blades, flowers;
};

Turf turf_surface(const TurfShape& shape, Seed seed);

}  // namespace frond
