#pragma once

#include "core/seed.h"
#include "core/vec.h"

namespace frond {

/// Smooth noise in -1..1 that is 0 on average, features about one unit wide (simplex noise, Perlin 2001).
double noise(Vec3 p);

/// Three independent such noises.
Vec3 noise3(Vec3 p);

/// `octaves` noises on top of each other, each of twice the frequency and half the strength; within -2..2.
double fractal_noise(Vec3 p, int octaves);

/// Where noise is taken from, so that no two things have the same: up to `most` along each axis, to either
/// side.
Vec3 random_shift(Seed seed, double most = 99);

}  // namespace frond
