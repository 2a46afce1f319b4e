#pragma once

#include <vector>

#include "motion/motion.h"

namespace frond {

/// How the limbs of a tree swing in the wind: each about its own base, on top of what bears it, so that
/// nothing comes apart; smaller ones (of a higher order) farther and faster. In a loop each frequency is a
/// whole number of swings.
class LimbSway {
 public:
  LimbSway(const Skeleton& rest, const Wave& wave, double time, double film_length);

  /// The turn of node `i`, given the turns of all nodes before it.
  Quat turn(std::size_t i, const std::vector<Quat>& turns);

 private:
  static constexpr int kOrders = 5;

  const Skeleton& rest_;
  Vec3 along_, across_;
  float amplitude_, wave_number_;
  float push_[kOrders], side_[kOrders];  ///< phases of the two swings of each order now
  std::vector<std::int32_t> base_;       ///< the node that bears each node's limb
};

/// How far leaves flutter, radians, and where in their flutter they are: see Pose.
void set_flutter(const Wave& wave, double time, double film_length, Pose& pose);

}  // namespace frond
