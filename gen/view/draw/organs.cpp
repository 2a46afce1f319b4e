#include "draw/organs.h"

#include <algorithm>

#include "core/parallel.h"
#include "core/seed.h"

namespace frond {

namespace {

constexpr std::size_t kSteps = 8;      // from the colour of a bud to that of the leaf
constexpr std::size_t kAtOnce = 1024;  // organs that one thread places

/// The colour of an organ that has come `step` of kSteps on its way from the bud.
Color unfolding_color(const Prototype& prototype, std::size_t color, std::size_t step) {
  const Color& last = prototype.colors[color];
  if (!prototype.bud) return last;
  return mixed(*prototype.bud, last, static_cast<float>(step + 1) / static_cast<float>(kSteps));
}

std::size_t steps_of(const Prototype& prototype) { return prototype.bud ? kSteps : 1; }

}  // namespace

std::size_t leaf_shade(std::uint32_t id) { return Seed{id}.bits() % kLeafShades; }

float largest_scale(const Organs& organs) {
  float largest = 0;
  for (const Vec3& scale : organs.scale) largest = std::max({largest, scale.x, scale.y, scale.z});
  return largest;
}

DrawnOrgans::DrawnOrgans(const Traits& traits, const Model& m, const Pose& pose, double time,
                         std::span<const char> replaced) {
  constexpr auto kNone = static_cast<std::uint32_t>(-1);
  std::size_t count = 0, n = m.organs.size();
  std::vector<std::size_t> first_of;  // group of each prototype
  for (const Prototype& p : m.prototypes) {
    first_of.push_back(count);
    count += p.colors.size() * steps_of(p) * kLeafShades;
  }
  auto size_of = [&](std::size_t i) {
    return unfolded(m.organs.birth[i], pose.front, unfold_time(traits.motion));
  };
  std::vector<std::uint32_t> group_of(n, kNone);
  std::vector<std::size_t> begin(count + 1, 0);
  for (std::size_t i = 0; i < n; ++i) {
    if (!replaced.empty() && replaced[i]) continue;
    float size = size_of(i);
    if (size < kUnfoldedLeast) continue;
    std::size_t which = m.organs.prototype[i], steps = steps_of(m.prototypes[which]);
    std::size_t color = color_index(m.organs.color[i], m.prototypes[which].colors.size());
    // Colour lags behind size: a leaf is fully grown before it is dark.
    auto step = std::min(static_cast<std::size_t>(size * size * static_cast<float>(steps)), steps - 1);
    group_of[i] = static_cast<std::uint32_t>(first_of[which] + (color * steps + step) * kLeafShades +
                                             leaf_shade(m.organs.id[i]));
    ++begin[group_of[i] + 1];
  }
  for (std::size_t k = 0; k < count; ++k) begin[k + 1] += begin[k];
  order_.resize(begin[count]);
  std::vector<std::size_t> next = begin;
  for (std::size_t i = 0; i < n; ++i)
    if (group_of[i] != kNone) order_[next[group_of[i]]++] = static_cast<std::uint32_t>(i);
  places_.resize(order_.size());
  parallel_for((order_.size() + kAtOnce - 1) / kAtOnce, [&](std::size_t part) {
    for (std::size_t k = part * kAtOnce; k < std::min(order_.size(), (part + 1) * kAtOnce); ++k)
      places_[k] = organ_place(m, traits.motion, pose, time, order_[k], size_of(order_[k]));
  });
  for (std::size_t p = 0; p < m.prototypes.size(); ++p) {
    const Prototype& prototype = m.prototypes[p];
    std::size_t steps = steps_of(prototype), groups_of = prototype.colors.size() * steps * kLeafShades;
    for (std::size_t k = 0, at = first_of[p]; k < groups_of; ++k, ++at) {
      if (begin[at] == begin[at + 1]) continue;
      std::size_t color = k / kLeafShades / steps;
      groups.push_back({p, color, k % kLeafShades, unfolding_color(prototype, color, k / kLeafShades % steps),
                        begin[at], begin[at + 1]});
    }
  }
}

std::vector<DrawnBlades> drawn_blades(const Traits& traits, const Model& model, const Pose& pose) {
  std::vector<DrawnBlades> drawn;
  if (model.blades.size() == 0) return drawn;
  std::size_t colors = traits.look.blades.colors.size();
  std::vector<bool> used(colors * kLeafShades);
  for (std::size_t i = 0; i < model.blades.size(); ++i)
    used[color_index(model.blades.color[i], colors) * kLeafShades + leaf_shade(model.blades.id[i])] = true;
  for (std::size_t k = 0; k < used.size(); ++k) {
    if (!used[k]) continue;
    Surface surface =
        posed_blades(model.skeleton, pose, model.blades, traits.motion.growth.ripen, [&](std::size_t i) {
          return color_index(model.blades.color[i], colors) == k / kLeafShades &&
                 leaf_shade(model.blades.id[i]) == k % kLeafShades;
        });
    if (!surface.triangle.empty()) drawn.push_back({k / kLeafShades, k % kLeafShades, std::move(surface)});
  }
  return drawn;
}

}  // namespace frond
