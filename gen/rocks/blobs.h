#pragma once

#include <vector>

#include "core/seed.h"
#include "core/vec.h"
#include "model/implicit.h"
#include "rocks/interval.h"

namespace frond {

/// f at a place.
double field_value(const Blobs& shape, const DVec3& p);

/// The gradient of f at a place; it points inward.
DVec3 field_gradient(const Blobs& shape, const DVec3& p);

/// How strongly the level surface through a place bends: not less than its largest curvature there, in one by
/// the unit of the radii; infinite where the gradient vanishes.
double field_curvature(const Blobs& shape, const DVec3& p);

/// Bounds of f over a box, by interval arithmetic (Moore 1966), rounded outward: f takes no value outside of
/// them. Each term is bounded exactly, only their sum is not.
Interval field_range(const Blobs& shape, const Box& box);

/// Bounds of the derivative of f along `direction` over a box; the same holds.
Interval field_slope_range(const Blobs& shape, const Box& box, const DVec3& direction);

/// A box that holds the whole surface, as tight as interval arithmetic makes it in a few steps; of size 0 at
/// the origin where there is none.
Box field_bounds(const Blobs& shape);

/// A bound of the length of the gradient over a box, by interval arithmetic on a few hundred parts of it.
double field_steepest(const Blobs& shape, const Box& box);

/// How blobs are drawn at random.
struct BlobChance {
  int count = 6;              ///< 1 and more
  double least_radius = 0.5;  ///< of each axis
  double most_radius = 2;
};

/// Random ellipsoids, each within the box that is as wide, high and deep as the largest of them are.
std::vector<Blob> random_blobs(const BlobChance& chance, Seed seed);

}  // namespace frond
