#pragma once

#include <vector>

#include "core/seed.h"
#include "land/meadow_plant.h"
#include "model/surface.h"

namespace frond {

/// A patch of turf of a square metre or less.
struct TurfShape {
  double side = 0.5;         ///< metres, of the square patch about the origin
  double blend = 0;          ///< metres over which it thins out at each edge, half of them outside the square
  double blade = 0.1;        ///< metres, length of a blade
  double density = 900;      ///< plants or blades per square metre
  double flowers = 0;        ///< share of them replaced by a flower
  std::vector<Sward> sward;  ///< mixture of plants; empty: grass
  bool thin = false;         ///< whether it has a spot of bare earth in the middle
};

/// A patch of a meadow. `uv` of blades: u from root to tip, v a random number per blade. Of leaves and
/// flowers v is such a number in 0..0.9 plus an integer for the type: see `Meadow_Leaf` and `Meadow_Bloom`.
struct Turf {
  Surface blades, leaves, flowers;
};

Turf turf_surface(const TurfShape& shape, Seed seed);

}  // namespace frond
