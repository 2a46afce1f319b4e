#pragma once

#include "core/seed.h"
#include "model/surface.h"

namespace frond {

/// A weathered stone about one metre wide round the origin: a flattened sphere displaced by noise.
/// Star-shaped, so that there is one surface point in each direction.
struct Stone {
  Seed seed;
  double roughness = 0.35;  ///< 0 a smooth egg .. 1 very rough
  double flatness = 0.35;   ///< 0 as high as wide .. 0.9 a slab
};

/// The surface point in a direction (need not be of length 1, not 0).
Vec3 stone_surface_point(const Stone& stone, Vec3 direction);

/// The stone as a mesh of 20 * 4^detail triangles; detail 0 to 6.
Surface stone_surface(const Stone& stone, int detail);

}  // namespace frond
