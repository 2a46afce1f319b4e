#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/vec.h"

namespace frond {

/// Branches as a structure of arrays, one entry per node. A segment runs from a node's parent to the node.
/// Parents precede children, and the nodes of one branch are consecutive: a run of nodes whose parent is the
/// node before them is one chain. Plain data; metres.
struct Skeleton {
  static constexpr std::int32_t kRoot = -1;

  std::vector<Vec3> position;
  std::vector<float> radius;         ///< > 0
  std::vector<std::int32_t> parent;  ///< index of the parent, or kRoot
  std::vector<float> distance;       ///< along the branches from the root
  std::vector<float> to_tip;         ///< along the branches to the farthest tip above; see set_tip_distances
  std::vector<float> birth;          ///< 0..1: the share of growth after which the node is reached
  std::vector<std::uint16_t> order;  ///< depth of branching: 0 on the trunk

  std::size_t size() const { return position.size(); }
  void reserve(std::size_t nodes);

  /// Appends a node. `distance` is computed from the parent; `to_tip` and `birth` are 0 until set.
  std::int32_t add(Vec3 at, float thickness, std::int32_t below, std::uint16_t depth);

  /// The largest distance of any node; 0 for an empty skeleton.
  float longest() const;

  /// Checks all invariants: one line for the first violation, empty if there is none.
  std::string find_fault() const;
};

/// The last node of the chain that begins at `first`.
std::int32_t chain_end(const Skeleton& skeleton, std::int32_t first);

/// Sets each node's distance: its length along the branches from the root.
void set_distances(Skeleton& skeleton);

/// Sets `to_tip` of each node from the positions.
void set_tip_distances(Skeleton& skeleton);

/// Orders the nodes so that each branch continues through its forks: of the children of a node, the first
/// with the lowest order comes directly after it, then the others. Returns the new index of each node.
std::vector<std::int32_t> order_branches(Skeleton& skeleton);

/// Sets each `birth` to the node's distance divided by the largest one: growth has the same speed along all
/// branches.
void set_births(Skeleton& skeleton);

}  // namespace frond
