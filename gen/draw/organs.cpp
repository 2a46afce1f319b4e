#include "draw/organs.h"

#include <algorithm>
#include <cmath>

#include "core/seed.h"
#include "motion/unfold.h"

namespace frond {

namespace {

constexpr std::size_t kSteps = 8;  // from the colour of a bud to that of the leaf

/// The colour of an organ that has come `step` of kSteps on its way from the bud.
Color unfolding_color(const Prototype& prototype, std::size_t color, std::size_t step) {
  const Color& last = prototype.colors[color];
  if (!prototype.bud) return last;
  return mixed(*prototype.bud, last, static_cast<float>(step + 1) / static_cast<float>(kSteps));
}

std::size_t steps_of(const Prototype& prototype) { return prototype.bud ? kSteps : 1; }

float size_of(const Specimen& b, const Pose& pose, std::size_t i) {
  return unfolded(b.model.organs.birth[i], pose.front, unfold_time(b.motion));
}

}  // namespace

std::size_t leaf_shade(std::uint32_t id) { return Seed{id}.bits() % kLeafShades; }

DrawnOrgans::DrawnOrgans(const Specimen& specimen, const Pose& pose, double time)
    : specimen_(specimen), pose_(pose), time_(time) {
  constexpr auto kNone = static_cast<std::uint32_t>(-1);
  const Model& m = specimen.model;
  std::size_t count = 0, n = m.organs.size();
  std::vector<std::size_t> first_of;  // group of each prototype
  for (const Prototype& p : m.prototypes) {
    first_of.push_back(count);
    count += p.colors.size() * steps_of(p) * kLeafShades;
  }
  std::vector<std::uint32_t> group_of(n, kNone);
  std::vector<std::size_t> begin(count + 1, 0);
  for (std::size_t i = 0; i < n; ++i) {
    float size = size_of(specimen, pose, i);
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

OrganPlace DrawnOrgans::place(std::uint32_t i) const {
  const Organs& o = specimen_.model.organs;
  Quat turn = organ_turn(pose_, o, i);
  float flutter = pose_.flutter * (o.loose.empty() ? 1 : 1 - o.loose[i]);
  if (flutter > 0) {
    float phase = pose_.flutter_phase + 2.39996f * static_cast<float>(o.id[i] % 4096);
    turn = turn * glm::angleAxis(flutter * std::sin(phase), Vec3(1, 0, 0)) *
           glm::angleAxis(0.7f * flutter * std::sin(phase + 1.1f), Vec3(0, 1, 0));
  }
  if (const Motion& motion = specimen_.motion; !o.supple.empty())
    turn = turn * fluttering(motion.flutter, motion.film_length, time_, o.position[i], o.id[i], o.supple[i]);
  return {organ_place(specimen_.model.skeleton, pose_, o, i), turn,
          o.scale[i] * size_of(specimen_, pose_, i)};
}

}  // namespace frond
