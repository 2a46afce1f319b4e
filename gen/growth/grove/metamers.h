#pragma once

#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace frond {

/// The state of one tree: one entry per metamer, which is an internode, the bud beside its upper end and, at
/// the end of an axis, the terminal bud. Structure of arrays; parents precede children. Entry 0 is the
/// collar: no length, at the foot.
struct Metamers {
  static constexpr std::int32_t kRoot = -1;
  static constexpr float kNever = 1e9f;
  enum Flag : std::uint8_t {
    side_shoot = 1,  ///< the first internode of an axis that leaves another one
    leading = 2,     ///< bears a living terminal bud
    bud = 4,         ///< bears a living lateral bud
    dead = 8,
    woken = 16,   ///< its lateral bud sprouts by what the wood has stored, since what was above is cut off
    spent = 32,   ///< its lateral bud came from old wood
    regrown = 64  ///< the first internode of an axis from such a bud
  };

  std::vector<Vec3> tip;   ///< its upper end, metres
  std::vector<Vec3> side;  ///< of length 1, toward its lateral bud
  std::vector<std::int32_t> parent;
  std::vector<std::uint32_t> serial;  ///< serial number in order of birth in the tree
  std::vector<float> born;            ///< years, a share of the year included
  std::vector<float> died;            ///< years, or kNever
  std::vector<float> pipe;            ///< its radius to the power n, in units of a twig's; never decreases
  std::vector<float> light;           ///< 0..1 at its buds, this year
  std::vector<std::uint8_t> flags;
  std::vector<std::uint8_t> order;  ///< 0 on the stem

  // Results of the passes of a year: first light from above, then resource from below.
  std::vector<float> to_leader, to_side;
  std::vector<float> count;  ///< number of living internodes at and above it

  std::size_t size() const { return tip.size(); }
  void resize(std::size_t n);
  bool has(std::size_t i, Flag flag) const { return (flags[i] & flag) != 0; }
  void set(std::size_t i, Flag flag) { flags[i] = static_cast<std::uint8_t>(flags[i] | flag); }
  void clear(std::size_t i, Flag flag) { flags[i] = static_cast<std::uint8_t>(flags[i] & ~flag); }

  /// Direction of its internode; the collar points up.
  Vec3 heading(std::size_t i) const {
    if (parent[i] == kRoot) return {0, 1, 0};
    Vec3 offset = tip[i] - tip[parent[i]];
    float length = glm::length(offset);
    return length > 0 ? offset / length : Vec3(0, 1, 0);
  }
  float length(std::size_t i) const {
    return parent[i] == kRoot ? 0.0f : glm::distance(tip[i], tip[parent[i]]);
  }

  /// Keeps the entries for which `stay` is true; children of a removed parent are removed too.
  void keep(const std::vector<std::uint8_t>& stay);
};

}  // namespace frond
