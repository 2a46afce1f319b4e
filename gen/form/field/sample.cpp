#include <array>
#include <limits>

#include "field/branch_volume.h"

namespace frond {

namespace {

constexpr float kNone = std::numeric_limits<float>::max();
constexpr float kTurning = 0.6f;  // of an arm's width, in which its direction turns round a bend

Nearest nearest_of(const BranchVolume& boughs, const Forks& forks, const Arm& arm, Vec3 at) {
  Nearest best{kNone, 0};
  for (std::uint32_t m = arm.first; m < arm.last; ++m) {
    float d = distance(boughs.cones[forks.member[m]], at);
    if (d < best.distance) best = {d, forks.member[m]};
  }
  return best;
}

/// The directions in which the arms of a fork face at one place.
struct Faces {
  const BranchVolume& boughs;
  const Forks& forks;
  const Arm* arms_of;
  std::span<const Nearest> arms;
  Vec3 at;
  std::array<Vec3, kMostArms> direction{};
  std::array<bool, kMostArms> known{};

  /// That of the nearest cone; near a bend it turns into that of the next, or the surface would have a step
  /// there.
  Vec3 of(std::size_t a) {
    if (known[a]) return direction[a];
    known[a] = true;
    const Arm& arm = arms_of[a];
    if (arm.last - arm.first == 1) return direction[a] = outward(boughs.cones[arms[a].cone], at);
    float span = kTurning * arm.width;
    Vec3 sum(0);
    for (std::uint32_t m = arm.first; m < arm.last; ++m) {
      const RoundCone& cone = boughs.cones[forks.member[m]];
      float share = 1 - (distance(cone, at) - arms[a].distance) / span;
      if (share > 0) sum += share * share * outward(cone, at);
    }
    float length = glm::length(sum);
    return direction[a] = length > 1e-6f ? sum / length : outward(boughs.cones[arms[a].cone], at);
  }
};

}  // namespace

/// The arms of a fork flow into each other: a smooth minimum (the quadratic one of Quilez 2013), but only as
/// far as they face different ways, so that an arm does not swell where another leaves it from within (the
/// idea of Gourmel et al. 2013, A gradient-based implicit blend).
FieldSample blend_arms(const BranchVolume& boughs, const Forks& forks, std::size_t f,
                       std::span<const Nearest> near, Vec3 at, bool with_normal) {
  const Arm* arms = forks.arms.data() + forks.forks[f].first;
  Faces faces{boughs, forks, arms, near, at};
  std::array<float, kMostArms> weight{};  // of each arm's slope in that of the whole
  std::size_t count = near.size(), least = 0;
  for (std::size_t a = 1; a < count; ++a)
    if (near[a].distance < near[least].distance) least = a;
  float low = near[least].distance, pushed = 0;
  weight[least] = 1;
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = a + 1; b < count; ++b) {
      float width = std::min(arms[a].width, arms[b].width);
      float near_a = width - (near[a].distance - low), near_b = width - (near[b].distance - low);
      if (near_a <= 0 || near_b <= 0) continue;
      float apart = smooth_step(0.02f, 0.7f, 1 - glm::dot(faces.of(a), faces.of(b)));
      if (apart == 0) continue;
      near_a /= width, near_b /= width;
      float both = near_a * near_b;
      pushed += apart * both * both * width / 4;
      float share_a = apart * both * near_b / 2, share_b = apart * both * near_a / 2;
      weight[a] += share_a, weight[b] += share_b;
      weight[least] -= share_a + share_b;
    }
  }
  FieldSample sample{low - pushed, Vec3(0), static_cast<std::int32_t>(near[least].cone)};
  if (!with_normal) return sample;
  for (std::size_t a = 0; a < count; ++a)
    if (weight[a] != 0) sample.normal += weight[a] * faces.of(a);
  float length = glm::length(sample.normal);
  sample.normal = length > 1e-6f ? sample.normal / length : faces.of(least);
  return sample;
}

FieldSample sample_boughs(const BranchVolume& boughs, const Nearby& near, Vec3 at) {
  FieldSample best{kNone, Vec3(0), -1};
  for (std::uint32_t i : near.cones) {
    float d = distance(boughs.cones[i], at);
    if (d < best.distance) best.distance = d, best.cone = static_cast<std::int32_t>(i);
  }
  bool filleted = false;
  for (std::size_t f = 0; f < near.forks.size(); ++f) {
    std::array<Nearest, kMostArms> arms;
    std::size_t first = near.forks.forks[f].first, count = near.forks.forks[f].last - first;
    float least = kNone, second = kNone, width = 0;
    for (std::size_t a = 0; a < count; ++a) {
      const Arm& arm = near.forks.arms[first + a];
      arms[a] = nearest_of(boughs, near.forks, arm, at);
      second = std::min(second, std::max(arms[a].distance, least));
      least = std::min(least, arms[a].distance);
      width = std::max(width, arm.width);
    }
    // The cones alone say the same where no two arms are near each other, or the fork is farther than they
    // are.
    if (second - least >= width || least - fillet_reach(near.forks, f) >= best.distance) continue;
    FieldSample fork = blend_arms(boughs, near.forks, f, std::span(arms.data(), count), at, true);
    if (fork.distance >= best.distance) continue;
    best.distance = fork.distance, best.normal = fork.normal;
    if (best.cone < 0) best.cone = fork.cone;
    filleted = true;
  }
  if (!filleted && best.cone >= 0) best.normal = outward(boughs.cones[best.cone], at);
  return best;
}

Nearby all_of(const BranchVolume& boughs) {
  Nearby all{{}, boughs.forks, 0};
  for (std::uint32_t i = 0; i < boughs.cones.size(); ++i) all.cones.push_back(i);
  return all;
}

float fillet_reach(const Forks& forks, std::size_t f) {
  const Forks::Fork& fork = forks.forks[f];
  float most = 0, count = static_cast<float>(fork.last - fork.first);
  for (std::uint32_t a = fork.first; a < fork.last; ++a) most = std::max(most, forks.arms[a].width);
  return count * (count - 1) / 2 * most / 4;
}

bool choose_fork(const BranchVolume& boughs, const Forks& from, std::size_t f, Vec3 at, float half,
                 float band, Forks* to) {
  const Forks::Fork& fork = from.forks[f];
  std::array<float, kMostArms> arm;
  std::array<float, kMostMembers> known;
  float least = kNone, second = kNone, width = 0;
  std::size_t begin = from.arms[fork.first].first;
  for (std::uint32_t a = fork.first; a < fork.last; ++a) {
    float& d = arm[a - fork.first] = kNone;
    for (std::uint32_t m = from.arms[a].first; m < from.arms[a].last; ++m) {
      float& own = known[m - begin] = distance(boughs.cones[from.member[m]], at);
      d = std::min(d, own);
    }
    second = std::min(second, std::max(d, least));
    least = std::min(least, d);
    width = std::max(width, from.arms[a].width);
  }
  // Two arms must be near enough to each other to be blended, and the surface near.
  float span = width + 2 * half;
  if (second - least >= span || least - half >= band + fillet_reach(from, f) || least + half <= -band)
    return false;
  if (!to) return true;
  Forks::Fork kept{static_cast<std::uint32_t>(to->arms.size()), 0};
  for (std::uint32_t a = fork.first; a < fork.last; ++a) {
    float d = arm[a - fork.first];
    if (d - least >= span) continue;
    Arm own{static_cast<std::uint32_t>(to->member.size()), 0, from.arms[a].width};
    for (std::uint32_t m = from.arms[a].first; m < from.arms[a].last; ++m)
      if (known[m - begin] <= d + 2 * half + kTurning * own.width) to->member.push_back(from.member[m]);
    own.last = static_cast<std::uint32_t>(to->member.size());
    to->arms.push_back(own);
  }
  kept.last = static_cast<std::uint32_t>(to->arms.size());
  to->forks.push_back(kept);
  return true;
}

void choose_near(const BranchVolume& boughs, const Nearby& from, Vec3 at, float half, float band,
                 Nearby& to) {
  std::array<float, 256> known;
  to.cones.clear();
  to.forks.clear();
  to.middle = kNone;
  for (std::size_t i = 0; i < from.cones.size(); ++i) {
    float d = distance(boughs.cones[from.cones[i]], at);
    if (i < known.size()) known[i] = d;
    to.middle = std::min(to.middle, d);
  }
  // The nearest anywhere in the ball is in its middle at most so much farther than the nearest there.
  for (std::size_t i = 0; i < from.cones.size(); ++i) {
    float d = i < known.size() ? known[i] : distance(boughs.cones[from.cones[i]], at);
    if (d <= to.middle + 2 * half) to.cones.push_back(from.cones[i]);
  }
  for (std::size_t f = 0; f < from.forks.size(); ++f)
    choose_fork(boughs, from.forks, f, at, half, band, &to.forks);
}

}  // namespace frond
