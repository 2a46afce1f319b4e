#pragma once

#include <vector>

#include "core/seed.h"
#include "core/vec.h"

namespace frond {

/// A place with the room that it needs round it.
struct Spot {
  Vec2 at{0};
  float radius = 0;
};

/// Up to `count` places in the ring of `inner` to `outer` metres about `centre`, none nearer to another, or
/// to one of `taken`, than the sum of their radii (Poisson disk by throwing darts). Where the room runs out
/// there are fewer.
std::vector<Spot> scatter(Vec2 centre, double inner, double outer, float radius, int count,
                          const std::vector<Spot>& taken, Seed seed);

}  // namespace frond
