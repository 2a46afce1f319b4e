#pragma once

#include <functional>
#include <vector>

#include "core/seed.h"
#include "model/surface.h"

// Accretion
// =========
// Stony corals grow by adding skeleton under a living skin. Each point of the skin moves outward along its
// normal, faster where more light and food arrive, and the skin gets new polyps where it is stretched
// (radiate accretive growth: Kaandorp 1994; Kaandorp and Kuebler 2001). No rule places the branches: a bump
// receives more than a hollow, so bumps become fingers where food dominates and domes where it does not.

namespace frond {

/// How a skin grows.
struct Accretion {
  double across = 0.2, up = 0.3;  ///< metres that it reaches where nothing is in the way, > 0
  int layers = 60;                ///< number of layers of skeleton
  double edge = 0.008;            ///< metres, of the triangles, > 0
  double light = 0.6;       ///< share of the growth driven by light from above; the rest comes from all sides
  double hunger = 1;        ///< how much faster bumps grow than hollows: 0 not at all
  double upward = 0;        ///< -1 grows sideways, 0 equally in all directions, 1 upward
  double lumps = 0.15;      ///< how unevenly polyps grow, 0 .. 1
  double lump_size = 0.06;  ///< metres from lump to lump
  double smoothing = 0.3;   ///< per layer, 0 none .. 1
};

/// The surroundings of a skin, in its own space.
struct AccretionWorld {
  /// A lower bound of the free distance from a point, metres; negative inside an obstacle. Many threads ask.
  std::function<float(Vec3 at, float within)> room;
  /// The share of the light from above that reaches a point, 0..1; empty: all.
  std::function<float(Vec3 at)> light = {};
};

/// A fully grown skin.
struct Accreted {
  Surface surface;                      ///< closed; its foot at the origin
  std::vector<std::vector<Vec3>> past;  ///< see Solid::past
  std::vector<float> birth;             ///< of each vertex, 0..1: when the skeleton under it was laid
  std::vector<float> shade;             ///< of each vertex, 0 fully open .. 1 where no light arrives
};

/// Grows a skin; a pure function.
Accreted accrete(const Accretion& law, const AccretionWorld& world, Seed seed);

}  // namespace frond
