#include "appearance/coral_health.h"

#include <algorithm>
#include <cmath>

#include "appearance/bleaching.h"
#include "appearance/skin_colors.h"
#include "core/bounds.h"
#include "core/linear.h"

namespace frond {

namespace {

constexpr float kPales = 0.95f, kWhite = 0.55f;  // health at which it begins to pale, and is white
constexpr float kDies = 0.45f, kDead = 0.12f;    // health at which parts begin to die, and all is dead
constexpr float kUniform = 0.7f;                 // share that is dead, from which on turf is everywhere
constexpr int kTurfs = 5;                        // places on a body that turf spreads from
constexpr float kLeastTurf = 2e-4f;              // metres, radius of a patch that shows

/// A linear colour of tissue so bleached, where turf lies evenly.
Vec3 tissue_in(Vec3 light, const Bleached& b, float turf) {
  return glm::mix(glm::mix(light, bleached_color(light), b.pale), dead_color(light), turf);
}

Color tissue_in(const Color& color, const Bleached& b, float turf) {
  return srgb(glm::clamp(tissue_in(linear(color), b, turf), Vec3(0), Vec3(1)));
}

void still(Polyps& polyps, const Bleached& b) {
  const double living = 1 - static_cast<double>(b.dead);
  polyps.glow = polyps.glow * living * (1 - static_cast<double>(b.pale)) + static_cast<double>(b.glow);
  // White polyps stay drawn in for the most part.
  polyps.width = b.dead >= 1 ? 0 : polyps.width * living;
}

}  // namespace

Bleached bleached_at(const Health& health, const Fare& fare) {
  Bleached b;
  b.pale = 1 - smooth_step(kWhite, kPales, fare.now);
  b.dead = 1 - smooth_step(kDead, kDies, fare.least);
  // Highest as it begins to pale, and gone when it is white.
  const float begun = smooth_step(0.0f, 0.35f, b.pale) * (1 - smooth_step(0.35f, 0.95f, b.pale));
  b.glow = static_cast<float>(health.fluoresces) * begun * (1 - b.dead);
  return b;
}

Skin skin_in(const Skin& skin, const Bleached& b) {
  Skin now = skin;
  auto shown = [&](const Color& color) {
    return srgb(glm::clamp(tissue_in(tinted(color, skin.tint), b, b.dead), Vec3(0), Vec3(1)));
  };
  now.tint.base = shown(skin.tint.base), now.tint.secondary = shown(skin.tint.secondary);
  now.tint.course = {};
  now.tint.young *= 1 - static_cast<double>(std::max(b.pale, b.dead));
  still(now.polyps, b);
  return now;
}

Material material_in(const Material& material, const Bleached& b) {
  if (!is_tissue(material.matter)) return material;
  Material now = material;
  const float even = smooth_step(kUniform, 1.0f, b.dead);
  now.color = tissue_in(material.color, b, even), now.second = tissue_in(material.second, b, even);
  now.gloss *= 1 - static_cast<double>(b.dead);
  still(now.polyps, b);
  return now;
}

std::vector<DeadPatch> turf_on(const Surface& skin, Seed seed) {
  std::vector<DeadPatch> patches;
  if (skin.position.empty()) return patches;
  const Bounds box = bounds_of(skin.position);
  const float across = glm::length(box.size());
  for (std::uint64_t k = 0; k < kTurfs; ++k) {
    const Seed own = seed.child("turf", k);
    const auto radius = static_cast<float>(own.child("size").range(0.55, 0.8)) * across;
    patches.push_back({skin.position[own.child("at").bits() % skin.position.size()], radius});
  }
  return patches;
}

std::vector<DeadPatch> turf_at(const std::vector<DeadPatch>& own, const std::vector<DeadPatch>& turf,
                               float dead) {
  std::vector<DeadPatch> patches;
  // The border is ragged in proportion to the first of them, which must not be too small.
  for (const DeadPatch& patch : turf)
    if (float radius = patch.radius * std::pow(dead, 1.2f); radius >= kLeastTurf)
      patches.push_back({patch.at, radius});
  patches.insert(patches.end(), own.begin(), own.end());
  return patches;
}

}  // namespace frond
