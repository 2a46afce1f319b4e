#pragma once

#include <functional>
#include <vector>

#include "core/seed.h"
#include "model/surface.h"

// Accretion
// =========
// Stony corals grow by laying skeleton under a living skin: each place of it moves outward along its normal,
// the faster the more light and food come to it, and the skin bears new polyps where it is stretched (radiate
// accretive growth: Kaandorp 1994; Kaandorp and Kuebler 2001). Nothing says where branches are to be: what
// stands out sees more than what lies back, so that bumps become fingers where food counts, and domes where
// it does not.

namespace frond {

/// How a skin grows.
struct Accretion {
  double across = 0.2, up = 0.3;  ///< metres that it comes to where nothing is in the way, > 0
  int layers = 60;                ///< of skeleton, one on another
  double edge = 0.008;            ///< metres, of the triangles, > 0
  double light = 0.6;   ///< share of the growth that light from above drives; the rest comes from all sides
  double hunger = 1;    ///< how much faster what stands out grows than what lies back: 0 not at all
  double upward = 0;    ///< -1 spreads, 0 all alike, 1 rises
  double lumps = 0.15;  ///< how uneven polyps are, 0 .. 1
  double lump_size = 0.06;  ///< metres from lump to lump
  double smoothing = 0.3;   ///< 0 none .. 1, of one layer
};

/// What a skin has round it, in its own space.
struct AccretionWorld {
  /// Metres that are free from a place on, at least; less than 0 in what stands there. Asked by many threads.
  std::function<float(Vec3 at, float within)> room;
  /// The share of the light from above that is left at a place, 0..1; empty: all.
  std::function<float(Vec3 at)> light = {};
};

/// A skin that has grown.
struct Accreted {
  Surface surface;                      ///< closed; its foot at the origin
  std::vector<std::vector<Vec3>> past;  ///< see Solid::past
  std::vector<float> birth;             ///< of each vertex, 0..1: when the skeleton was laid that it lies on
  std::vector<float> shade;             ///< of each vertex, 0 in the open .. 1 where nothing comes
};

/// Grows a skin; a pure function.
Accreted accrete(const Accretion& law, const AccretionWorld& world, Seed seed);

}  // namespace frond
