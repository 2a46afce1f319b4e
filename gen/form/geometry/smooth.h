#pragma once

#include "model/skeleton.h"

namespace frond {

/// The branches of a skeleton with `pieces` (1 or more) nodes for each of its nodes, on a smooth curve
/// through them (spline_slopes): radii and births follow linearly, a branch leaves its parent in its own
/// direction.
Skeleton smooth(const Skeleton& coarse, int pieces);

/// Where each coarse node is among those that smooth() makes.
std::vector<std::int32_t> smoothed_index(const Skeleton& coarse, int pieces);

}  // namespace frond
