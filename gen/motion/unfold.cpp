#include "motion/unfold.h"

#include <algorithm>

namespace frond {

float unfolded(float birth, float front, double ripen) {
  // What is born last still has all of `ripen` left.
  return smooth_step(0.0f, static_cast<float>(std::max(ripen, 1e-3)), front - birth);
}

}  // namespace frond
