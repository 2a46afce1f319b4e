#pragma once

#include <vector>

#include "core/seed.h"
#include "land/meadow_plant.h"
#include "model/surface.h"

namespace frond {

/// What grows on a square metre or less.
struct TurfShape {
  double side = 0.5;     ///< metres, of the square patch about the origin
  double blend = 0;      ///< metres that it thins out over at each edge, half of them outside of the square
  double blade = 0.1;    ///< metres, length of a blade
  double density = 900;  ///< plants or blades a square metre
  double flowers = 0;    ///< share of them that bear a flower instead
  std::vector<Sward> sward;  ///< what they are; nothing: grass
  bool thin = false;         ///< with a spot of bare earth about the middle
};

/// A patch of a meadow. `uv` of blades: u from root to tip, v a number of the blade's own. Of leaves and
/// flowers v is such a number of 0..0.9 after a whole one that says what it is: see `Meadow_Leaf` and
/// `Meadow_Bloom`.
struct Turf {
  Surface blades, leaves, flowers;
};

Turf turf_surface(const TurfShape& shape, Seed seed);

}  // namespace frond
