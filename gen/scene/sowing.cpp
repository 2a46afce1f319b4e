#include "scene/sowing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace frond {

double sown_size(const Stage& stage) {
  switch (stage.setting) {
    case Setting::underwater:
      return 44;  // as far as there is a floor
    case Setting::studio:
      return std::sqrt(2.0) * stage.studio.distance;  // before the wall, wherever that stands
    case Setting::meadow:
    case Setting::garden:
      return 200;
    case Setting::forest:
      return stage.forest.terrain.size;
  }
  return 0;
}

namespace {

/// Up from the ground.
Vec3 ground_normal(const Heights& heights, Vec2 at) {
  constexpr float kReach = 0.5f;  // metres
  auto x = static_cast<float>(heights(at.x - kReach, at.y) - heights(at.x + kReach, at.y));
  auto z = static_cast<float>(heights(at.x, at.y - kReach) - heights(at.x, at.y + kReach));
  return glm::normalize(Vec3(x, 2 * kReach, z));
}

Land land_of(const Scene& scene, const Heights& heights, std::vector<Spot> taken) {
  constexpr int kSamples = 128;
  Land land;
  land.size = sown_size(scene.stage);
  land.taken = std::move(taken);
  if (scene.stage.setting == Setting::studio) return land;
  double lowest = 1e9;
  for (int i = 0; i <= kSamples; ++i)
    for (int k = 0; k <= kSamples; ++k)
      lowest = std::min(lowest, heights((static_cast<double>(i) / kSamples - 0.5) * land.size,
                                        (static_cast<double>(k) / kSamples - 0.5) * land.size));
  land.altitude = [&heights, lowest](Vec2 at) { return heights(at.x, at.y) - lowest; };
  land.slope = [&heights](Vec2 at) { return std::acos(std::min(ground_normal(heights, at).y, 1.0f)); };
  const Plot& plot = scene.plot;
  if (plot.has_path() || plot.has_pond())
    land.path = [&plot](Vec2 at) {
      // In the water nothing comes up, however near to a path it may.
      return plot.pond_distance(at) < 0.1 ? -1e6 : std::min(plot.path_distance(at), plot.pond_distance(at));
    };
  return land;
}

/// How a copy is turned: about itself, leaning as it likes, and as the ground asks.
Quat turn_of(const Organism& organism, Seed seed, Vec3 normal) {
  const Place& place = organism.place;
  Vec3 up(0, 1, 0);
  double turn = place.turn + place.turn_variation * seed.child("turn").range(-1, 1);
  double toward = seed.child("toward").range(0, 2 * kPi);
  Vec3 axis(static_cast<float>(std::cos(toward)), 0, static_cast<float>(std::sin(toward)));
  Quat lean = glm::angleAxis(static_cast<float>(place.lean * seed.child("lean").unit()), axis);
  Vec3 across = glm::cross(up, normal);
  double slope = std::asin(std::min(glm::length(across), 1.0f)) * (1 - organism.sown->upright);
  Quat tilt =
      slope > 1e-5 ? glm::angleAxis(static_cast<float>(slope), glm::normalize(across)) : Quat(1, 0, 0, 0);
  return glm::normalize(tilt * lean * glm::angleAxis(static_cast<float>(turn), up));
}

Copies copies_of(const Organism& organism, const std::vector<Sprout>& sprouts, const Heights* heights) {
  Copies copies;
  for (const Sprout& sprout : sprouts) {
    Vec3 normal = heights ? ground_normal(*heights, sprout.at) : Vec3(0, 1, 0);
    double height = heights ? (*heights)(sprout.at.x, sprout.at.y) : 0;
    // A little in the ground, the deeper the steeper that is.
    double stem = std::min(organism.sown->where.stem, 0.2) * sprout.size;
    double sunk = organism.place.raise > 0 ? 0 : stem * (0.1 + 0.5 * (1 - normal.y));
    copies.model.push_back(sprout.model);
    copies.foot.emplace_back(sprout.at.x, height + organism.place.raise - sunk, sprout.at.y);
    copies.turn.push_back(turn_of(organism, sprout.seed, normal));
    copies.scale.push_back(sprout.size);
    copies.tint.push_back(static_cast<std::uint8_t>(sprout.seed.child("tint").bits() % kTints));
  }
  return copies;
}

}  // namespace

void sow_stands(Scene& scene, const Preset& preset, const Heights& heights, std::vector<Spot> taken) {
  std::vector<SowOrder> orders;
  for (std::size_t o = 0; o < preset.organisms.size(); ++o) {
    const Organism& organism = preset.organisms[o];
    if (!organism.sown || organism.count == 0) continue;
    Seed seed = Seed{preset.seed}.child("organism", o);
    scene.stands.push_back({o, organism, {}});
    orders.push_back({organism.sown->where, organism.count, organism.place.size_variation,
                      organism.sown->models, organism.place.at, seed});
  }
  if (orders.empty()) return;
  std::vector<std::vector<Sprout>> sown = sow(orders, land_of(scene, heights, std::move(taken)));
  bool level = scene.stage.setting == Setting::studio;  // its floor is one with the wall
  for (std::size_t i = 0; i < sown.size(); ++i) {
    SownStand& stand = scene.stands[i];
    const Organism& organism = preset.organisms[stand.entry];
    stand.copies = copies_of(organism, sown[i], level ? nullptr : &heights);
    if (static_cast<int>(sown[i].size()) < organism.count)
      scene.notes.push_back(
          fmt::format("{}: only {} of {} found room; sown.where less strict, or its radius less?",
                      organism.name.empty() ? fmt::format("organism {}", stand.entry) : organism.name,
                      sown[i].size(), organism.count));
  }
}

}  // namespace frond
