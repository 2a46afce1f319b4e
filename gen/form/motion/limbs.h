#pragma once

#include <vector>

#include "motion/motion.h"

namespace frond {

/// Swinging of a tree's limbs in the wind: each about its own base, in addition to the motion of its parent,
/// so that they stay connected; limbs of higher order swing farther and faster. In a loop each frequency is
/// an integer number of swings.
class LimbSway {
 public:
  LimbSway(const Skeleton& rest, const Wave& wave, double time, double film_length);

  /// The rotation of node `i`, given those of all nodes before it.
  Quat turn(std::size_t i, const std::vector<Quat>& turns);

 private:
  static constexpr int kOrders = 5;

  const Skeleton& rest_;
  Vec3 along_, across_;
  float amplitude_, wave_number_;
  float push_[kOrders], side_[kOrders];  ///< current phases of the two swings of each order
  std::vector<std::int32_t> base_;       ///< node to which each node's limb is attached
};

/// Amplitude and phase of the flutter of leaves, radians: see Pose.
void set_flutter(const Wave& wave, double time, double film_length, Pose& pose);

}  // namespace frond
