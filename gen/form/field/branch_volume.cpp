#include "field/branch_volume.h"

#include <algorithm>
#include <cassert>

namespace frond {

namespace {

constexpr float kReach = 6;  // radii from a fork to the end of what is blended there

/// Follows the branches from the forks of one skeleton.
class Joiner {
 public:
  Joiner(BranchVolume& boughs, const Skeleton& rest, std::span<const float> radius, float blend)
      : boughs_(boughs),
        rest_(rest),
        radius_(radius),
        blend_(blend),
        cone_(rest.size(), -1),
        children_(rest.size(), 0) {}

  void add_cone(std::int32_t i, const RoundCone& cone) {
    assert(rest_.parent[i] >= 0 && cone_[i] < 0);
    cone_[i] = static_cast<std::int32_t>(boughs_.cones.size());
    ++children_[rest_.parent[i]];
    boughs_.cones.push_back(cone);
  }

  /// Makes the forks, of nodes with two children and more.
  void add_forks() {
    std::size_t n = rest_.size();
    std::vector<std::int32_t> fork(n, -1);
    std::vector<std::vector<std::int32_t>> branches;
    for (std::size_t i = 0; i < n; ++i) {
      std::int32_t p = rest_.parent[i];
      if (p == Skeleton::kRoot || cone_[i] < 0 || children_[p] < 2) continue;
      std::int32_t& of = fork[p];
      if (of < 0) of = static_cast<std::int32_t>(branches.size()), branches.emplace_back().push_back(p);
      branches[of].push_back(static_cast<std::int32_t>(i));
    }
    for (const auto& list : branches) add_fork(list);
  }

 private:
  /// `list` holds the node of the fork, then its children.
  void add_fork(const std::vector<std::int32_t>& list) {
    assert(list.size() >= 3 && "a node and two children at least");
    std::int32_t node = list[0];
    float reach = kReach * radius_[node];
    Forks::Fork fork{static_cast<std::uint32_t>(boughs_.forks.arms.size()), 0};
    if (cone_[node] >= 0) {
      begin_arm(radius_[node]);
      float length = 0;
      for (std::int32_t i = node; length < reach && takes(i);
           i = forks(rest_.parent[i]) ? -1 : rest_.parent[i])
        length += add_member(i);
      end_arm();
    }
    for (std::size_t k = 1; k < list.size() && boughs_.forks.arms.size() - fork.first < kMostArms; ++k) {
      begin_arm(radius_[list[k]]);
      float length = 0;
      for (std::int32_t i = list[k]; length < reach && takes(i); i = forks(i) ? -1 : next(i))
        length += add_member(i);
      end_arm();
    }
    fork.last = static_cast<std::uint32_t>(boughs_.forks.arms.size());
    boughs_.forks.forks.push_back(fork);
  }

  bool takes(std::int32_t i) const {
    return i >= 0 && cone_[i] >= 0 &&
           boughs_.forks.member.size() - boughs_.forks.arms.back().first < kMostCones;
  }
  /// An arm ends at the next fork, which has arms of its own.
  bool forks(std::int32_t i) const { return i >= 0 && children_[i] > 1; }
  std::int32_t next(std::int32_t i) const {
    return i + 1 < static_cast<std::int32_t>(rest_.size()) && rest_.parent[i + 1] == i ? i + 1 : -1;
  }
  float add_member(std::int32_t i) {
    auto cone = static_cast<std::uint32_t>(cone_[i]);
    boughs_.forks.member.push_back(cone);
    return boughs_.cones[cone].length;
  }
  void begin_arm(float thick) {
    boughs_.forks.arms.push_back(
        {static_cast<std::uint32_t>(boughs_.forks.member.size()), 0, blend_ * thick});
  }
  void end_arm() { boughs_.forks.arms.back().last = static_cast<std::uint32_t>(boughs_.forks.member.size()); }

  BranchVolume& boughs_;
  const Skeleton& rest_;
  std::span<const float> radius_;
  float blend_;
  std::vector<std::int32_t> cone_;      // of each node, or -1
  std::vector<std::int32_t> children_;  // of each node, that are there
};

}  // namespace

void add_boughs(BranchVolume& boughs, const Skeleton& rest, std::span<const Vec3> position,
                std::span<const float> radius, float front, float blend, std::int32_t first_node) {
  assert(position.size() == rest.size() && radius.size() == rest.size());
  Joiner joiner(boughs, rest, radius, blend);
  std::vector<std::int32_t> root(rest.size());
  for (std::size_t i = 0; i < rest.size(); ++i) {
    std::int32_t p = rest.parent[i];
    auto node = static_cast<std::int32_t>(i);
    root[i] = p == Skeleton::kRoot ? node : root[p];
    if (p == Skeleton::kRoot || rest.birth[p] >= front) continue;
    float foot = radius[p];
    assert(foot >= 0 && radius[i] >= 0);
    // A branch leaves its parent little thicker than it goes on, or the fork would swell.
    if (p != node - 1) foot = std::min(foot, 1.25f * radius[i]);
    RoundCone cone = make_cone(position[p], foot, position[i], radius[i], first_node + node);
    cone.root = first_node + root[i];
    joiner.add_cone(node, cone);
  }
  if (blend > 0) joiner.add_forks();
}

BranchVolume at_least_as_thick(const BranchVolume& boughs, float radius) {
  BranchVolume thick = boughs;
  for (RoundCone& cone : thick.cones) {
    if (std::min(cone.radius, cone.end_radius()) >= radius) continue;
    std::int32_t root = cone.root;
    cone = make_cone(cone.from, std::max(cone.radius, radius), cone.to(), std::max(cone.end_radius(), radius),
                     cone.node);
    cone.root = root;
  }
  return thick;
}

BranchVolume boughs_of(const Skeleton& rest, float blend) {
  BranchVolume boughs;
  add_boughs(boughs, rest, rest.position, rest.radius, 2, blend);
  return boughs;
}

}  // namespace frond
