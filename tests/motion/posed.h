#pragma once

#include "motion/motion.h"

namespace frond {

inline Pose posed(const Skeleton& s, const Motion& motion, double time) {
  Pose pose;
  pose_skeleton(s, motion, time, pose);
  return pose;
}

}  // namespace frond
