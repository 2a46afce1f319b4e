#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/skeleton.h"
#include "model/surface.h"

namespace frond {

/// Branches as tubes.
struct TubeMesh {
  Surface surface;                 ///< `uv`: once round the branch, and metres along it
  std::vector<std::int32_t> node;  ///< of each vertex: the node of its ring
};

/// Each branch of a skeleton as one closed tube with a rounded end, smooth along it and twisted as little as
/// can be (Wang et al. 2008, double reflection). `position` and `radius` have an entry a node; what is born
/// after `front` is not there yet. `sides` is 3 or more. Triangles are closed where vertices at one place are
/// one.
TubeMesh branch_tubes(const Skeleton& rest, std::span<const Vec3> position, std::span<const float> radius,
                      float front, int sides);

}  // namespace frond
