#pragma once

#include <cstdint>
#include <vector>

#include "model/skeleton.h"

namespace frond {

/// Where a leaf or a sprig stands on a tree: its foot, and how it is turned from growing along +y with its
/// upper side toward +z.
struct LeafSite {
  Vec3 position{0};
  Quat turn{1, 0, 0, 0};
  float size = 1;         ///< share of a full-grown leaf
  std::int32_t node = 0;  ///< of the skeleton that it rides on
};

/// Branches with their leaves; metres, the foot at the origin.
struct Crown {
  Skeleton skeleton;
  std::vector<LeafSite> leaves;
};

}  // namespace frond
