#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "emit/pov.h"
#include "light/light.h"
#include "world/specimen.h"

namespace frond {

/// A place of a triangle, by the shares that its corners have in it.
struct Foothold {
  std::array<std::uint32_t, 3> corner;
  Vec3 share;

  Vec3 of(const std::vector<Vec3>& v) const {
    return share.x * v[corner[0]] + share.y * v[corner[1]] + share.z * v[corner[2]];
  }
};
/// Where polyps stand on each of an organism's solids, all its life.
using PolypPlaces = std::vector<std::vector<Foothold>>;
PolypPlaces polyp_places(const Solids& solids);

/// The polyps of living bodies at a time, each on a place of its own, which the skin carries along as it
/// grows. Those that face away, or that are too small to be seen from `eye`, are left out.
ObjectText polyps_text(const PovSpace& space, const Solids& solids, const PolypPlaces& places,
                       const Growth& growth, double time, const Eye& eye);

/// The same of branches: all round them by the golden angle, and one on each tip.
ObjectText branch_polyps_text(const PovSpace& space, const Specimen& b, const Pose& pose, double time,
                              const Eye& eye);

}  // namespace frond
