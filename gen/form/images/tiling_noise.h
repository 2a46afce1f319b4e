#pragma once

#include "core/seed.h"

namespace frond {

/// Perlin noise of the plane (Perlin 2002), about -1..1, that repeats after `across` and `along` units,
/// integers > 0.
double tiling_noise(double x, double y, int across, int along, Seed seed);

/// `octaves` of it, each of twice the frequency and `gain` times the amplitude; about -1..1.
double tiling_fractal(double x, double y, int across, int along, int octaves, double gain, Seed seed);

/// Distances to the nearest and second nearest of random points, one per unit square (Worley 1996), and a
/// random number 0..1 of the nearest point. Repeats as above.
struct Cells {
  double nearest, second, own;
};
Cells tiling_cells(double x, double y, int across, int along, Seed seed);

}  // namespace frond
