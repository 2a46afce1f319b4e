#pragma once

#include <vector>

#include "core/seed.h"
#include "core/vec.h"
#include "model/implicit.h"
#include "rocks/interval.h"

namespace frond {

/// f at a point.
double field_value(const Blobs& shape, const DVec3& p);

/// The gradient of f at a point; it points inward.
DVec3 field_gradient(const Blobs& shape, const DVec3& p);

/// An upper bound of the curvature of the level surface through a point, in 1 / unit of the radii; infinite
/// where the gradient vanishes.
double field_curvature(const Blobs& shape, const DVec3& p);

/// Bounds of f over a box by interval arithmetic (Moore 1966), rounded outward: f takes no value outside.
/// Each term is bounded exactly, but not their sum.
Interval field_range(const Blobs& shape, const Box& box);

/// Bounds of the derivative of f along `direction` over a box, by interval arithmetic, rounded outward.
Interval field_slope_range(const Blobs& shape, const Box& box, const DVec3& direction);

/// A box that contains the whole surface, tightened by a few steps of interval arithmetic; of size 0 at the
/// origin if there is no surface.
Box field_bounds(const Blobs& shape);

/// A bound of the gradient's length over a box, by interval arithmetic on a few hundred parts of it.
double field_steepest(const Blobs& shape, const Box& box);

/// How blobs are drawn at random.
struct BlobChance {
  int count = 6;              ///< 1 or more
  double least_radius = 0.5;  ///< of each axis
  double most_radius = 2;
};

/// Random ellipsoids, each inside the bounding box of the largest one.
std::vector<Blob> random_blobs(const BlobChance& chance, Seed seed);

}  // namespace frond
