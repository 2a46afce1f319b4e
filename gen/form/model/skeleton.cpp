#include "model/skeleton.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/keep.h"

namespace frond {

void Skeleton::reserve(std::size_t nodes) {
  reserve_all(nodes, position, radius, parent, distance, to_tip, birth, order);
}

std::int32_t Skeleton::add(Vec3 at, float thickness, std::int32_t below, std::uint16_t depth) {
  assert(below >= kRoot && below < static_cast<std::int32_t>(size()));
  float along = below == kRoot ? 0.0f : distance[below] + glm::distance(position[below], at);
  position.push_back(at);
  radius.push_back(thickness);
  parent.push_back(below);
  distance.push_back(along);
  to_tip.push_back(0);
  birth.push_back(0);
  order.push_back(depth);
  return static_cast<std::int32_t>(size()) - 1;
}

float Skeleton::longest() const {
  return distance.empty() ? 0.0f : *std::max_element(distance.begin(), distance.end());
}

std::string Skeleton::find_fault() const {
  std::size_t n = size();
  if (radius.size() != n || parent.size() != n || distance.size() != n || to_tip.size() != n ||
      birth.size() != n || order.size() != n)
    return "the arrays differ in length";
  for (std::size_t i = 0; i < n; ++i) {
    Vec3 p = position[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return fmt::format("node {} is not at a finite place", i);
    if (!(radius[i] > 0) || !std::isfinite(radius[i]))
      return fmt::format("node {} has radius {}", i, radius[i]);
    if (parent[i] < kRoot || parent[i] >= static_cast<std::int32_t>(i))
      return fmt::format("node {} has parent {}, which does not precede it", i, parent[i]);
    if (!(birth[i] >= 0 && birth[i] <= 1)) return fmt::format("node {} is born at {}", i, birth[i]);
    if (parent[i] != kRoot && birth[i] < birth[parent[i]])
      return fmt::format("node {} is born before its parent {}", i, parent[i]);
  }
  return {};
}

std::int32_t chain_end(const Skeleton& s, std::int32_t first) {
  auto n = static_cast<std::int32_t>(s.size());
  while (first + 1 < n && s.parent[first + 1] == first) ++first;
  return first;
}

void set_distances(Skeleton& s) {
  assert(s.distance.size() == s.size() && s.parent.size() == s.size());
  for (std::size_t i = 0; i < s.size(); ++i) {
    std::int32_t p = s.parent[i];
    s.distance[i] = p == Skeleton::kRoot ? 0 : s.distance[p] + glm::distance(s.position[p], s.position[i]);
  }
}

void set_tip_distances(Skeleton& s) {
  assert(s.to_tip.size() == s.size() && s.distance.size() == s.size());
  std::fill(s.to_tip.begin(), s.to_tip.end(), 0.0f);
  for (std::size_t i = s.size(); i-- > 0;) {
    std::int32_t p = s.parent[i];
    if (p != Skeleton::kRoot)
      s.to_tip[p] = std::max(s.to_tip[p], s.to_tip[i] + s.distance[i] - s.distance[p]);
  }
}

std::vector<std::int32_t> order_branches(Skeleton& s) {
  std::size_t n = s.size();
  // Each node's children as a list threaded through the nodes, the one that goes on in front.
  std::vector<std::int32_t> child(n, -1), sibling(n, -1), index(n, -1), stack;
  for (std::size_t i = n; i-- > 0;) {
    std::int32_t p = s.parent[i], node = static_cast<std::int32_t>(i);
    if (p == Skeleton::kRoot) continue;
    std::int32_t first = child[p];
    if (first >= 0 && s.order[i] > s.order[first]) {
      sibling[i] = sibling[first];
      sibling[first] = node;
    } else {
      sibling[i] = first;
      child[p] = node;
    }
  }
  Skeleton sorted;
  sorted.reserve(n);
  for (std::size_t root = 0; root < n; ++root) {
    if (s.parent[root] != Skeleton::kRoot) continue;
    stack.push_back(static_cast<std::int32_t>(root));
    while (!stack.empty()) {
      std::int32_t i = stack.back(), p = s.parent[i];
      stack.pop_back();
      index[i] = sorted.add(s.position[i], s.radius[i], p == Skeleton::kRoot ? p : index[p], s.order[i]);
      sorted.birth.back() = s.birth[i];
      sorted.to_tip.back() = s.to_tip[i];
      std::size_t low = stack.size();
      for (std::int32_t c = child[i]; c >= 0; c = sibling[c]) stack.push_back(c);
      std::reverse(stack.begin() + static_cast<std::ptrdiff_t>(low), stack.end());
    }
  }
  s = std::move(sorted);
  assert(s.size() == n && "every node hangs on a root");
  return index;
}

void set_births(Skeleton& s) {
  assert(s.birth.size() == s.size() && s.distance.size() == s.size());
  float longest = s.longest();
  for (std::size_t i = 0; i < s.size(); ++i)
    s.birth[i] = longest > 0 ? std::min(s.distance[i] / longest, 1.0f) : 0.0f;
}

}  // namespace frond
