#pragma once

#include <functional>

#include "core/seed.h"
#include "core/vec.h"

// How leaves, petals and fruit come down.

namespace frond {

/// Height of the ground at x, z; empty: leaves do not lie on it.
using GroundAt = std::function<double(double, double)>;

/// Something on its way down.
struct Flight {
  Vec3 position;
  Quat turn;
  float loose = 0;  ///< 0 on its twig .. 1 free
};

/// What is light, at a share of its fall, 0..1: tumbling, aside, and then lying flat.
Flight flight(Vec3 from, Quat turn, float fallen, Seed own, const GroundAt& ground);

/// What is heavy: straight down, and then lying on its side. `half`: of its width, metres.
Flight dropped(Vec3 from, Quat turn, float fallen, float half, Seed own, const GroundAt& ground);

}  // namespace frond
