#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "world/specimen.h"

// The organs of a specimen at one time: placements of its prototypes, by what they look like.

namespace frond {

inline constexpr std::size_t kLeafShades = 3;  ///< of each colour, so that leaves differ
/// Which of the shades the organ or blade of that number has.
std::size_t leaf_shade(std::uint32_t id);

/// Organs that share a shape and a look.
struct OrganGroup {
  std::size_t prototype = 0;
  std::size_t color = 0;           ///< index of the prototype's colours, and of its parts' pictures
  std::size_t shade = 0;           ///< 0 .. kLeafShades - 1
  Color tint;                      ///< sRGB: that colour, or one on the way to it from the bud's
  std::size_t begin = 0, end = 0;  ///< in the order of DrawnOrgans
};

/// Takes the prototype's axes to the world's; metres.
struct OrganPlace {
  Vec3 at;
  Quat turn;
  Vec3 scale;
};

/// Those that have begun to unfold. Refers to the specimen and the pose.
class DrawnOrgans {
 public:
  DrawnOrgans(const Specimen& specimen, const Pose& pose, double time);

  /// By prototype, colour, age and shade; none is empty.
  std::vector<OrganGroup> groups;

  std::span<const std::uint32_t> organs(const OrganGroup& group) const {
    return std::span(order_).subspan(group.begin, group.end - group.begin);
  }
  /// Where organ `i` is, as unfolded and fluttering as it is then.
  OrganPlace place(std::uint32_t i) const;

 private:
  const Specimen& specimen_;
  const Pose& pose_;
  double time_;
  std::vector<std::uint32_t> order_;
};

}  // namespace frond
