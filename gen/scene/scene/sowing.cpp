#include "scene/sowing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/copies.h"
#include "scene/entry_seeds.h"

namespace frond {

namespace {

/// How a copy is turned: about itself, leaning as it likes, and as the ground asks.
Quat turn_of(const Organism& organism, Seed seed, Vec3 normal) {
  const Place& place = organism.place;
  Vec3 up(0, 1, 0);
  double turn = place.turn + place.turn_variation * seed.child("turn").range(-1, 1);
  Vec3 across = glm::cross(up, normal);
  double slope = std::asin(std::min(glm::length(across), 1.0f));
  if (normal.y < 0) slope = kPi - slope;
  slope *= 1 - organism.sown->upright;
  Quat tilt =
      slope > 1e-5 ? glm::angleAxis(static_cast<float>(slope), glm::normalize(across)) : Quat(1, 0, 0, 0);
  return glm::normalize(tilt * lean_of(organism, seed) * glm::angleAxis(static_cast<float>(turn), up));
}

Copies copies_of(const Organism& organism, const std::vector<Sprout>& sprouts, const Heights& heights) {
  Copies copies;
  for (const Sprout& sprout : sprouts) {
    double height = heights(sprout.at.x, sprout.at.y);
    add_copy(copies, organism, sprout.seed, DVec3(sprout.at.x, height, sprout.at.y),
             ground_normal(heights, sprout.at), sprout.size, sprout.model);
  }
  return copies;
}

}  // namespace

void add_copy(Copies& copies, const Organism& organism, Seed seed, DVec3 foot, Vec3 normal, float size,
              std::uint16_t model) {
  // A little in the ground, the deeper the steeper that is.
  double stem = std::min(organism.sown->where.stem, 0.2) * size;
  double sunk = organism.place.raise > 0 ? 0 : stem * (0.1 + 0.5 * (1 - normal.y));
  copies.model.push_back(model);
  copies.foot.emplace_back(foot.x, foot.y + organism.place.raise - sunk, foot.z);
  copies.turn.push_back(turn_of(organism, seed, normal));
  copies.scale.push_back(size);
  copies.tint.push_back(static_cast<std::uint8_t>(seed.child("tint").bits() % kTints));
}

void note_room(Scene& scene, const Organism& organism, std::size_t entry, std::size_t found) {
  constexpr double kNearlyAll = 0.99;
  if (static_cast<double>(found) >= kNearlyAll * organism.count) return;
  scene.notes.push_back(fmt::format(
      "{}: only {} of {} found room; sown.where less strict, or its radius less?",
      organism.name.empty() ? fmt::format("organism {}", entry) : organism.name, found, organism.count));
}

void sow_copies(Scene& scene, const Preset& preset, const Grounds& ground, std::vector<Spot> taken) {
  std::vector<SowOrder> orders;
  std::vector<std::size_t> sets;  // of the orders
  std::vector<Seed> seeds = entry_seeds(preset, "organism");
  for (std::size_t o = 0; o < preset.organisms.size(); ++o) {
    const Organism& organism = preset.organisms[o];
    if (!organism.sown || organism.count == 0) continue;
    scene.copy_sets.push_back({o, organism, copy_appearance(organism), {}, {}});
    if (!organism.place.on.empty()) continue;  // bodies are not there yet
    SowRules where = organism.sown->where;
    if (preset.stand) where.shade = {0, 1};  // which is that of the trees, and another in each year
    orders.push_back({std::move(where), organism.count, organism.place.size_variation, organism.sown->models,
                      organism.place.at, seeds[o]});
    sets.push_back(scene.copy_sets.size() - 1);
  }
  if (orders.empty()) return;
  std::vector<std::vector<Sprout>> sown = sow(orders, ground.land(std::move(taken)));
  for (std::size_t i = 0; i < sown.size(); ++i) {
    CopySet& set = scene.copy_sets[sets[i]];
    const Organism& organism = preset.organisms[set.entry];
    set.copies = copies_of(organism, sown[i], ground.heights());
    note_room(scene, organism, set.entry, sown[i].size());
  }
}

}  // namespace frond
