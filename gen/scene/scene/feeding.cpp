#include "scene/feeding.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/parallel.h"

namespace frond {

namespace {

constexpr double kFeedingStep = 0.1;  // seconds
constexpr float kGrasp = 0.06f;       // metres from the skin of a tip, in which the swarm's middle is caught
constexpr double kUneaten = 1e9;

/// One food, and who eats of it: specimens and which of their foods it is.
struct Meal {
  const Animated<Vec3>* path;
  std::vector<std::pair<std::size_t, std::size_t>> eaters;
};

std::vector<Meal> meals_of(std::span<const Specimen> specimens) {
  std::vector<Meal> meals;
  for (std::size_t s = 0; s < specimens.size(); ++s) {
    const Food& food = specimens[s].motion.food;
    if (!food.eaten || !food.pulls() || specimens[s].model.skeleton.size() == 0) continue;
    for (std::size_t i = 0; i < food.places(); ++i) {
      auto same = std::ranges::find_if(meals, [&](const Meal& meal) { return *meal.path == food.place(i); });
      if (same == meals.end()) same = meals.insert(meals.end(), {&food.place(i), {}});
      same->eaters.emplace_back(s, i);
    }
  }
  return meals;
}

/// Whether a tip that has grown is at a place.
bool reaches(const Skeleton& rest, const Pose& pose, Vec3 place) {
  for (std::size_t i = 0; i < rest.size(); ++i)
    if (rest.birth[i] <= pose.front && rest.to_tip[i] <= 3 * rest.radius[i] &&
        glm::distance(pose.position[i], place) < pose.radius[i] + kGrasp)
      return true;
  return false;
}

}  // namespace

void feed(std::span<Specimen> specimens, double film) {
  std::vector<Meal> meals = meals_of(specimens);
  std::vector<std::size_t> hungry;
  for (const Meal& meal : meals)
    for (const auto& [s, i] : meal.eaters) {
      if (std::ranges::find(hungry, s) == hungry.end()) hungry.push_back(s);
      specimens[s].motion.food.reached.assign(specimens[s].motion.food.places(), kUneaten);
    }
  std::vector<Pose> pose(hungry.size());
  auto steps = static_cast<int>(std::floor(film / kFeedingStep));
  for (int step = 0; step <= steps && !meals.empty(); ++step) {
    double time = step * kFeedingStep;
    parallel_for(hungry.size(), [&](std::size_t h) { pose_specimen(specimens[hungry[h]], time, pose[h]); });
    std::erase_if(meals, [&](const Meal& meal) {
      bool caught = std::ranges::any_of(meal.eaters, [&](const auto& eater) {
        auto h = static_cast<std::size_t>(std::ranges::find(hungry, eater.first) - hungry.begin());
        return reaches(specimens[eater.first].model.skeleton, pose[h], meal.path->at(time));
      });
      for (const auto& [s, i] : meal.eaters)
        if (caught) specimens[s].motion.food.reached[i] = time;
      return caught;
    });
  }
}

}  // namespace frond
