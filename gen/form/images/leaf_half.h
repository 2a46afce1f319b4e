#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "images/leaf.h"

namespace frond {

/// Half of a flat blade as a mesh: x from the midrib outward, z how far it is raised.
struct HalfBlade {
  std::vector<Vec3> point;
  std::vector<std::array<std::uint32_t, 3>> triangle;  ///< facing up
};

/// The half with `points` on its rim.
HalfBlade half_blade(const LeafOutline& outline, int points);

/// The half folded along the secondaries of one side (1 right, -1 left): they lie in the valleys, and between
/// them the blade is raised by `pleat`, 0..1. Flat where the blade has none, or `points` are too few to show
/// it.
HalfBlade pleated_half(const LeafOutline& outline, int points, int side, double pleat);

}  // namespace frond
