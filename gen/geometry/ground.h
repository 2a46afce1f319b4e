#pragma once

#include "core/seed.h"
#include "model/surface.h"

namespace frond {

/// A floor of low dunes, level on average at y = 0.
struct Ground {
  Seed seed;
  double relief = 0.15;  ///< metres, the height of the dunes above and below the level
  double scale = 3;      ///< metres from dune to dune, > 0
};

/// How high the floor lies at (x, z).
double ground_height(const Ground& ground, double x, double z);

/// The floor as a round mesh about `centre` (x, z): fine in the middle, coarse toward `radius`, where the
/// relief is gone. `rings` (at least 2) sets how fine.
Surface ground_surface(const Ground& ground, Vec2 centre, double radius, int rings);

/// How high a mesh without overhangs lies at (x, z); 0 beside it.
double surface_height(const Surface& surface, double x, double z);

}  // namespace frond
