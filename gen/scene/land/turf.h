#pragma once

#include <vector>

#include "core/seed.h"
#include "model/surface.h"

namespace frond {

/// Plants of a meadow. Sizes are relative to the length of its grass.
enum class MeadowPlant {
  grass,      ///< blades of medium width
  fescue,     ///< tufts of blades as fine as threads
  cocksfoot,  ///< clumps of long broad blades
  panicle,    ///< culms with seed heads that stand above the rest
  clover,     ///< leaves of three leaflets with a pale chevron, white heads here and there
  daisy,      ///< spoons that lie flat about a white head with a yellow heart
  buttercup,  ///< yellow cups on stalks above leaves of three lobes
  plantain,   ///< ribbed lances about a brown spike
};

/// The share of one kind in a meadow.
struct Sward {
  MeadowPlant kind = MeadowPlant::grass;
  double share = 1;   ///< relative to the other shares
  double height = 1;  ///< factor of its size
};

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
