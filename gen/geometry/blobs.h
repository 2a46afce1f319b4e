#pragma once

#include <cstdint>
#include <vector>

#include "core/seed.h"
#include "core/vec.h"
#include "geometry/range.h"

namespace frond {

/// How the field of a blob falls off with d^2, the square of the distance from its middle in radii, where r
/// is the largest of its radii. Each is 1 in the middle and falls steadily; the last two end at d = r.
enum class Falloff : std::uint8_t {
  gaussian,  ///< exp(-r d^2) (Blinn 1982)
  soft,      ///< 1 - 4 d^6/9r^6 + 17 d^4/9r^4 - 22 d^2/9r^2 (Wyvill, McPheeters and Wyvill 1986)
  cubic,     ///< (1 - d^2/r^2)^3
};

/// One ellipsoid of an implicit surface.
struct Blob {
  DVec3 radius{1};  ///< along x, y and z, each > 0
  DVec3 center{0};  ///< in radii: its middle lies at radius * center
};

/// The implicit surface f(p) = 0 of the sum f of the fields of all blobs less `level`; inside f > 0.
/// A single blob at level 1 has no inside: its field is 1 in its middle only.
struct Blobs {
  std::vector<Blob> blobs;
  Falloff falloff = Falloff::gaussian;
  double level = 1;  ///< > 0
};

/// A box with sides along the axes.
struct Box {
  DVec3 low{0}, high{0};
  DVec3 middle() const { return (low + high) * 0.5; }
  DVec3 size() const { return high - low; }
};

/// f at a place.
double field_value(const Blobs& shape, const DVec3& p);

/// The gradient of f at a place; it points inward.
DVec3 field_gradient(const Blobs& shape, const DVec3& p);

/// How strongly the level surface through a place bends: not less than its largest curvature there, in one by
/// the unit of the radii; infinite where the gradient vanishes.
double field_curvature(const Blobs& shape, const DVec3& p);

/// Bounds of f over a box, by interval arithmetic (Moore 1966), rounded outward: f takes no value outside of
/// them. Each term is bounded exactly, only their sum is not.
Range field_range(const Blobs& shape, const Box& box);

/// Bounds of the derivative of f along `direction` over a box; the same holds.
Range field_slope_range(const Blobs& shape, const Box& box, const DVec3& direction);

/// A box that holds the whole surface, as tight as interval arithmetic makes it in a few steps; of size 0 at
/// the origin where there is none.
Box field_bounds(const Blobs& shape);

/// How blobs are drawn at random.
struct BlobChance {
  int count = 6;              ///< 1 and more
  double least_radius = 0.5;  ///< of each axis
  double most_radius = 2;
};

/// Random ellipsoids, each within the box that is as wide, high and deep as the largest of them are.
std::vector<Blob> random_blobs(const BlobChance& chance, Seed seed);

}  // namespace frond
