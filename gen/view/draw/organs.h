#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "motion/unfold.h"
#include "world/specimen.h"

// The organs and blades of an organism at one time, by what they look like.

namespace frond {

inline constexpr std::size_t kLeafShades = 3;  ///< of each colour, so that leaves differ
/// Which of the shades the organ or blade of that number has.
std::size_t leaf_shade(std::uint32_t id);

/// The largest scale of any organ along any axis; 0 where there is none.
float largest_scale(const Organs& organs);

/// Organs that share a shape and a look.
struct OrganGroup {
  std::size_t prototype = 0;
  std::size_t color = 0;           ///< index of the prototype's colours, and of its parts' pictures
  std::size_t shade = 0;           ///< 0 .. kLeafShades - 1
  Color tint;                      ///< sRGB: that colour, or one on the way to it from the bud's
  std::size_t begin = 0, end = 0;  ///< in the order of DrawnOrgans
};

/// Those that have begun to unfold.
class DrawnOrgans {
 public:
  /// `replaced`: of each organ whether it is left out; empty: none is.
  DrawnOrgans(const Traits& traits, const Model& model, const Pose& pose, double time,
              std::span<const char> replaced = {});

  /// By prototype, colour, age and shade; none is empty.
  std::vector<OrganGroup> groups;

  /// The numbers of a group's organs in the model.
  std::span<const std::uint32_t> organs(const OrganGroup& group) const {
    return std::span(order_).subspan(group.begin, group.end - group.begin);
  }
  /// Where they are, as unfolded and fluttering as they are then.
  std::span<const OrganPlace> places(const OrganGroup& group) const {
    return std::span(places_).subspan(group.begin, group.end - group.begin);
  }

 private:
  std::vector<std::uint32_t> order_;
  std::vector<OrganPlace> places_;
};

/// Blades of one colour and shade, as one mesh.
struct DrawnBlades {
  std::size_t color = 0, shade = 0;
  Surface surface;
};
/// None is empty.
std::vector<DrawnBlades> drawn_blades(const Traits& traits, const Model& model, const Pose& pose);

}  // namespace frond
