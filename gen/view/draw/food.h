#pragma once

#include <vector>

#include "core/vec.h"
#include "scene/scene.h"

namespace frond {

/// A ball of food; metres.
struct FoodGrain {
  Vec3 at{0};
  float radius = 0;
};

/// A swarm of plankton about the origin, some 0.3 m wide, at a time in seconds; it looks the same again after
/// `loop` seconds. The same for every place of food.
std::vector<FoodGrain> food_swarm(double time, double loop);

/// All that is left of the food in a scene at a time: one swarm after the other, in the order of
/// food_places().
std::vector<FoodGrain> drawn_food(const Scene& scene, double time);

}  // namespace frond
