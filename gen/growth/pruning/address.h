#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "model/model.h"

// Addresses of places on plants
// =============================
// A plant consists of axes, as botanists call them: an axis continues through its forks, and others leave it.
// An address names an axis by the way from the foot, and a place on it by the share of its length:
//
//     "3"          where the third branch leaves the stem, counted from the foot
//     "3/1:0.4"    four tenths along the first branch that leaves that one
//     ":0.7"       a place on the stem; "" is its foot
//     "#2/3:0.5"   the same of the second stem, where several rise from one foot; the first is "#1" or left
//     out
//
// Trees of gen/growth/grove count the nodes of the axis in place of its branches: "3" is what grows at the
// third node of the stem. So an address means the same branch in each year, whatever others were shed or cut
// meanwhile. A shoot that comes anew at a node where a branch was cut has 1000 added to its number.

namespace frond {

/// What an address looks like, for messages.
inline constexpr std::string_view kAddressForm =
    "numbers of branches with slashes and a share of the length from 0 to 1, as \"3/1:0.4\"";

struct Address {
  int stem = 1;           ///< counted from 1
  std::vector<int> axes;  ///< from axis to axis, the number of each among those that leave the one before
  double share = 0;       ///< 0..1 of the length of the last one, from where it leaves

  bool operator==(const Address&) const = default;
};

/// An error says what is expected in place of what was found.
Result<Address> parse_address(std::string_view text);
std::string text(const Address& address);

/// The branching of a plant by its nodes; parents precede children.
struct Branching {
  std::span<const std::int32_t> parent;
  std::span<const AxisNode> axes;  ///< where each node belongs
};

/// The axes of a skeleton, by its forks alone: the first child with the lowest order continues the axis.
std::vector<AxisNode> axis_nodes(const Skeleton& skeleton);
/// The axes that a model tells of, or else those of its skeleton.
std::vector<AxisNode> axis_nodes(const Model& model);

/// For each node, the first node of its axis.
std::vector<std::int32_t> axis_starts(const Branching& plant);

/// Calls `visit(i)` for a node and all that hangs on it, parents first.
template <class Visit>
void for_beyond(std::span<const std::int32_t> parent, std::int32_t node, const Visit& visit) {
  std::vector<std::uint8_t> beyond(parent.size());
  beyond[node] = 1;
  for (auto i = static_cast<std::size_t>(node); i < beyond.size(); ++i) {
    if (parent[i] != Skeleton::kRoot && beyond[parent[i]]) beyond[i] = 1;
    if (beyond[i]) visit(i);
  }
}

/// A place on a plant: on the segment that ends at a node.
struct BranchPlace {
  std::int32_t node = 0;
  float within = 1;  ///< 0..1 of that segment

  bool operator==(const BranchPlace&) const = default;
};

/// The place that an address names; an error tells how many branches there are instead.
Result<BranchPlace> find_place(const Branching& plant, std::span<const std::int32_t> starts,
                               const Address& address);

/// The address of a place. What belongs to no axis, as roots, is where it leaves one; none if it leaves none.
std::optional<Address> address_of(const Branching& plant, BranchPlace place);

}  // namespace frond
