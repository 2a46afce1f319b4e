#include "draw/food.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "core/seed.h"
#include "world/world.h"

namespace frond {

std::vector<FoodGrain> food_swarm(double time, double loop) {
  constexpr std::size_t kGrains = 90;
  constexpr double kReach = 0.15, kCircle = 0.02;    // metres, of the swarm and of each grain's way
  constexpr double kLeast = 0.0028, kMore = 0.0035;  // metres, radii
  std::vector<FoodGrain> grains;
  for (std::size_t i = 0; i < kGrains; ++i) {
    Seed seed = Seed{0}.child("food", i);
    // Denser toward the middle; each circles a little place of its own, a whole number of times in a loop.
    double away = kReach * std::pow(seed.child("away").unit(), 1.3),
           turns = 1 + std::floor(seed.child("turns").range(0, 3));
    double phase = 2 * kPi * (turns * time / std::max(loop, 0.001) + seed.child("phase").unit());
    double high = seed.child("high").range(-1, 1), round = seed.child("round").range(0, 2 * kPi);
    double flat = std::sqrt(1 - high * high);
    Vec3 out(flat * std::cos(round), high, flat * std::sin(round));
    Quat tilt = glm::angleAxis(static_cast<float>(seed.child("tilt").range(0, 2 * kPi)), Vec3(1, 0, 0));
    Vec3 on_circle(kCircle * std::cos(phase), 0, kCircle * std::sin(phase));
    double size = seed.child("size").unit();
    grains.push_back({static_cast<float>(away) * out + tilt * on_circle,
                      static_cast<float>(kLeast + kMore * size * size)});
  }
  return grains;
}

std::vector<FoodGrain> drawn_food(const Scene& scene, double time) {
  std::vector<FoodGrain> all, swarm = food_swarm(time, scene.film.length());
  for (const auto& [at, left] : food_places(scene.specimens, time)) {
    float scale = std::cbrt(left);
    for (const FoodGrain& grain : swarm) all.push_back({at + scale * grain.at, scale * grain.radius});
  }
  return all;
}

}  // namespace frond
