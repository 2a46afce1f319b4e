#pragma once

#include <cstdint>
#include <vector>

#include "model/skeleton.h"

namespace frond {

/// Position of a leaf or sprig on a tree: its foot, and its rotation from growing along +y with the upper
/// side toward +z.
struct LeafSite {
  Vec3 position{0};
  Quat turn{1, 0, 0, 0};
  float size = 1;         ///< share of a full-grown leaf
  std::int32_t node = 0;  ///< skeleton node that it is attached to
};

/// Branches with their leaves; metres, the foot at the origin.
struct Crown {
  Skeleton skeleton;
  std::vector<LeafSite> leaves;
};

}  // namespace frond
