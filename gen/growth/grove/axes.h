#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"
#include "model/model.h"

namespace frond {

/// To the number of a branch that a cut has called forth this is added.
inline constexpr std::int32_t kRegrown = 1000;

/// The axes of a tree whose internodes end at `tip`, parents first, see pruning/address.h. A branch has the
/// number of the node, counted along the axis that it leaves, at which it grows. `regrown(i)`: whether a cut
/// has called it forth. Shares are of the part of an axis that `stands(i)`, or of all of it if none does.
template <class Order, class Regrown, class Stands>
std::vector<AxisNode> nodal_axes(std::span<const std::int32_t> parent, const std::vector<Order>& order,
                                 std::span<const Vec3> tip, const Regrown& regrown, const Stands& stands) {
  const std::size_t n = parent.size();
  std::vector<AxisNode> axes(n);
  std::vector<std::int32_t> nodes(n), start(n);  // of its axis, up to it
  std::vector<float> along(n), standing(n), grown(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::int32_t p = parent[i];
    const bool foot = p == Skeleton::kRoot, continues = !foot && order[i] == order[p];
    start[i] = continues ? start[p] : static_cast<std::int32_t>(i);
    nodes[i] = foot ? 0 : continues ? nodes[p] + 1 : 1;
    along[i] = foot ? 0 : glm::distance(tip[i], tip[p]) + (continues ? along[p] : 0);
    if (!continues) axes[i].number = foot ? 1 : std::max(nodes[p], 1) + (regrown(i) ? kRegrown : 0);
    float& whole = grown[start[i]];
    whole = std::max(whole, along[i]);
    if (float& far = standing[start[i]]; stands(i)) far = std::max(far, along[i]);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const float length = standing[start[i]] > 0 ? standing[start[i]] : grown[start[i]];
    axes[i].share = length > 0 ? std::min(along[i] / length, 1.0f) : 0;
  }
  return axes;
}

}  // namespace frond
