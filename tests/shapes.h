#pragma once

#include <cmath>

#include "core/seed.h"
#include "model/skeleton.h"
#include "motion/motion.h"

namespace frond {

/// A straight trunk of `nodes` nodes, one metre a metre up.
inline Skeleton trunk(int nodes, float height = 1, float radius = 0.05f) {
  Skeleton s;
  for (int i = 0; i < nodes; ++i)
    s.add(Vec3(0, height * static_cast<float>(i) / static_cast<float>(nodes - 1), 0), radius, i - 1, 0);
  set_tip_distances(s);
  set_births(s);
  return s;
}

/// A trunk with `arms` branches of ten nodes each, all round it, bent and thinning.
inline Skeleton candelabrum(int arms, Seed seed) {
  Skeleton s = trunk(20);
  for (int arm = 0; arm < arms; ++arm) {
    Seed own = seed.child(static_cast<std::uint64_t>(arm));
    auto from = static_cast<std::int32_t>(2 + own.child("from").bits() % 17);
    float turn = static_cast<float>(own.child("turn").range(0, 2 * kPi));
    std::int32_t below = from;
    for (int i = 1; i <= 10; ++i) {
      float t = 0.06f * static_cast<float>(i);
      Vec3 out(std::cos(turn + t) * t, 0.8f * t, std::sin(turn + t) * t);
      below = s.add(s.position[from] + out, 0.03f - 0.0015f * static_cast<float>(i), below, 1);
    }
  }
  set_tip_distances(s);
  set_births(s);
  return s;
}

/// Growth, a strong current and food that moves, over four seconds.
inline Motion lively() {
  Motion motion;
  motion.film_length = 4;
  motion.growth = {0, 2, 0, 0.3};
  motion.wave.amplitude = radians(16.0);
  motion.food.strength = 1.4;
  motion.food.position = Animated<Vec3>(
      std::vector<Animated<Vec3>::Key>{{0, Vec3(2, 1, 0)}, {2, Vec3(0, 2, 2)}, {4, Vec3(-2, 1, 0)}});
  return motion;
}

}  // namespace frond
