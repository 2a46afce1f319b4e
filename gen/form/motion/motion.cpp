#include "motion/motion.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/limbs.h"

namespace frond {

namespace {

constexpr float kYoungRadius = 0.42f;  // of a growing tip, as a share of its final radius
constexpr double kOnset = 0.06;  // the share of growth in which the whole organism comes up from nothing

/// The swing of the current at one time, ready to be asked for each node.
class Current {
 public:
  Current(const Wave& wave, double time, double film_length) {
    assert(wave.length != 0);
    Vec3 flat(wave.direction.x, 0, wave.direction.z);
    along_ = glm::dot(flat, flat) > 0 ? glm::normalize(flat) : Vec3(1, 0, 0);
    across_ = Vec3(-along_.z, 0, along_.x);
    amplitude_ = static_cast<float>(wave.amplitude);
    wave_number_ = static_cast<float>(2 * kPi / wave.length);
    // Two swings whose rates are no simple ratio, so that no two strokes look alike; in a loop both are made
    // to fit a whole number of times.
    double slow = wave.speed, fast = wave.speed * 1.618;
    if (wave.loop && slow * film_length >= 0.5) {
      slow = std::round(slow * film_length) / film_length;
      fast = std::round(fast * film_length) / film_length;
    }
    slow_ = static_cast<float>(std::remainder(2 * kPi * slow * time + wave.phase, 2 * kPi));
    fast_ = static_cast<float>(std::remainder(2 * kPi * fast * time + 2.4 * wave.phase, 2 * kPi));
  }

  bool still() const { return amplitude_ == 0; }

  /// The turn at a place `share` (0..1) of the way to the farthest tip.
  Quat turn(Vec3 place, float share) const {
    float bend = amplitude_ * share * std::sqrt(share);
    float lag = wave_number_ * glm::dot(place, along_) + 1.2f * share;
    float push = bend * (0.25f + 0.75f * std::sin(slow_ - lag));
    float side = bend * 0.45f * std::sin(fast_ - 1.3f * lag);
    // Small turns about two level axes at once: one quaternion, exact in its length.
    Vec3 axis = across_ * -push + along_ * side;
    float angle = glm::length(axis);
    if (angle < 1e-7f) return Quat(1, 0, 0, 0);
    return glm::angleAxis(angle, axis / angle);
  }

 private:
  Vec3 along_, across_;
  float amplitude_, wave_number_, slow_, fast_;
};

/// The turn that brings a segment of direction `heading` that starts at `base` toward the food, `share` of
/// the way along its branch and `step` of it long.
Quat toward_food(Vec3 heading, Vec3 base, Vec3 food, const Food& pull, float strength, float share,
                 float step) {
  Vec3 to_food = food - base;
  float distance2 = glm::dot(to_food, to_food), reach2 = static_cast<float>(pull.reach * pull.reach);
  if (distance2 < 1e-12f) return Quat(1, 0, 0, 0);
  Vec3 axis = glm::cross(heading, to_food / std::sqrt(distance2));
  float sine = glm::length(axis);
  if (sine < 1e-6f) return Quat(1, 0, 0, 0);
  float supple = smooth_step(0.0f, 0.35f, share);
  // Food right behind pulls nowhere: else the least step of it would swing the branch from side to side.
  float before = 0.5f + 0.5f * glm::dot(heading, to_food) / std::sqrt(distance2);
  float angle = strength * supple * step * sine * before * distance2 / (distance2 + reach2);
  return glm::angleAxis(std::min(angle, std::asin(std::min(sine, 1.0f))), axis / sine);
}

/// All food that is left, and how much a part of a skeleton bends and stretches to each.
class Pull {
 public:
  /// `grown`: factor of strength and stretch; `longest`: metres, the longest branch of the skeleton.
  Pull(const Food& food, double time, float grown, float longest) : food_(food), longest_(longest) {
    strength_ = static_cast<float>(food.strength) * grown;
    stretch_ = static_cast<float>(food.stretch) * grown;
    for (std::size_t i = 0; grown > 0 && food.pulls() && i < food.places(); ++i)
      if (float left = food.left(i, time); left > 0) meals_.push_back({food.place(i).at(time), left});
  }

  bool bends() const { return strength_ != 0 && !meals_.empty(); }
  bool stretches() const { return stretch_ != 0 && !meals_.empty(); }

  /// The rotation as that of toward_food(), toward all food that is left, the nearest first of all.
  Quat turn(Vec3 heading, Vec3 base, float share, float step) const {
    if (meals_.size() == 1) return to(heading, base, 0, 1, share, step);
    float all = nearness_of_all(base);
    Quat turned(1, 0, 0, 0);
    for (std::size_t i = 0; i < meals_.size(); ++i)
      turned = to(turned * heading, base, i, nearness(i, base) / all, share, step) * turned;
    return turned;
  }

  /// A segment that starts at `base`, `share` of the way along its branch, scaled along the direction to the
  /// food: more the nearer it is to a tip and to the food, and not where it leads away from it.
  Vec3 stretched(Vec3 segment, Vec3 base, float share) const {
    float length = glm::length(segment), all = nearness_of_all(base);
    Vec3 longer = segment;
    for (std::size_t i = 0; i < meals_.size() && length > 0; ++i) {
      Vec3 to_food = meals_[i].at - base;
      float distance2 = glm::dot(to_food, to_food), reach2 = static_cast<float>(food_.reach * food_.reach);
      if (distance2 < 1e-12f) continue;
      Vec3 toward = to_food / std::sqrt(distance2);
      float along = glm::dot(segment, toward) / length;
      float near = longest_ * longest_ / (longest_ * longest_ + distance2) * distance2 / (distance2 + reach2);
      float more = stretch_ * meals_[i].left * (nearness(i, base) / all) * share * std::sqrt(share) * near;
      longer += toward * (more * length * along * smooth_step(0.0f, 0.5f, along));
    }
    return longer;
  }

 private:
  struct Meal {
    Vec3 at;
    float left;
  };

  float nearness(std::size_t i, Vec3 base) const {
    Vec3 to_food = meals_[i].at - base;
    float distance2 = glm::dot(to_food, to_food);
    return meals_[i].left / std::max(distance2 * distance2, 1e-12f);
  }
  float nearness_of_all(Vec3 base) const {
    float all = 0;
    for (std::size_t i = 0; i < meals_.size(); ++i) all += nearness(i, base);
    return all;
  }
  Quat to(Vec3 heading, Vec3 base, std::size_t i, float weight, float share, float step) const {
    return toward_food(heading, base, meals_[i].at, food_, strength_ * meals_[i].left * weight, share, step);
  }

  const Food& food_;
  float strength_, stretch_, longest_;
  std::vector<Meal> meals_;
};

}  // namespace

float Food::left(std::size_t i, double time) const {
  if (i >= reached.size()) return 1;
  return static_cast<float>(1 - smooth_step(reached[i], reached[i] + kMeal, time));
}

float cone_radius(float radius, float other, float length) {
  constexpr float kSteepest = 0.9f;  // metres of radius a metre
  return std::clamp(radius, other - kSteepest * length, other + kSteepest * length);
}

double growth_front(const Growth& growth, double time) {
  assert(growth.ripen >= 0 && std::isfinite(time));
  double end = 1 + growth.ripen;
  if (growth.duration <= 0) return time >= growth.start ? end : 0;
  double t = std::clamp((time - growth.start) / growth.duration, 0.0, 1.0);
  if (growth.ease) return end * eased(*growth.ease, t);
  // Fast in youth, slow in age, at rest at both ends.
  double eased = t * t * (3 - 2 * t);
  return end * (0.45 * eased + 0.55 * (1 - (1 - eased) * (1 - eased)));
}

namespace {

/// The share of its segment that growth has reached at node `i` above `p`; `born` is put off until it begins.
float reached_share(const Skeleton& rest, std::size_t i, std::int32_t p, float front, float& born) {
  if (rest.birth[i] <= front) return 1;
  float span = rest.birth[i] - rest.birth[p];
  born = std::max(born, rest.birth[p]);
  return span > 0 ? std::clamp((front - rest.birth[p]) / span, 0.0f, 1.0f) : 0.0f;
}

/// Scales a posed segment that starts at `base` toward the food, and rotates `turn` as it is rotated. Returns
/// how many times as long it is now.
float stretch(const Pull& food, Vec3 base, float share, Vec3& segment, Quat& turn) {
  Vec3 longer = food.stretched(segment, base, share);
  float length = glm::length(segment);
  if (length <= 0) return 1;
  turn = Quat(segment, longer) * turn;
  segment = longer;
  return glm::length(longer) / length;
}

/// Sets the radius of node `i` above `p`, thinner where it is stretched, so that its volume stays.
void set_radius(std::size_t i, std::int32_t p, float radius, Pose& pose) {
  if (!pose.stretch.empty()) radius /= std::sqrt(pose.stretch[i]);
  if (p != Skeleton::kRoot && p == static_cast<std::int32_t>(i) - 1)
    radius = cone_radius(radius, pose.radius[p], glm::distance(pose.position[i], pose.position[p]));
  pose.radius[i] = radius;
}

/// The lowest node of a piece that has broken off is moved aside as the stem is at its height: where the limb
/// was when it broke, and back at rest on the ground.
void carry_broken(const Skeleton& rest, const Sway& sway, std::size_t i, Pose& pose) {
  float height = rest.position[i].y;
  std::size_t below = 0, above = 0;
  while (above < i && sway.limb[above] == 0 && rest.position[above].y <= height) below = above++;
  if (above == 0 || above == i || sway.limb[above] != 0) above = below;
  float step = rest.position[above].y - rest.position[below].y;
  float share = step > 0 ? (height - rest.position[below].y) / step : 0;
  Vec3 low = pose.position[below] - rest.position[below], high = pose.position[above] - rest.position[above];
  pose.position[i] += glm::mix(low, high, share);
  pose.turn[i] = glm::slerp(pose.turn[below], pose.turn[above], share);
}

}  // namespace

void pose_skeleton(const Skeleton& rest, const Motion& motion, double time, Pose& pose) {
  assert(rest.radius.size() == rest.size() && rest.parent.size() == rest.size());
  assert(rest.distance.size() == rest.size() && rest.birth.size() == rest.size());
  std::size_t n = rest.size();
  pose.position.resize(n);
  pose.radius.resize(n);
  pose.turn.resize(n);
  pose.front = static_cast<float>(growth_front(motion.growth, time));

  pose.flutter = pose.flutter_phase = 0;
  std::optional<WindLoads> wind;
  std::optional<LimbSway> limbs;
  if (motion.sway) {
    wind.emplace(rest, *motion.sway, time, motion.exposure);
    wind->set_flutter(pose);
  } else if (motion.limbs && motion.wave.amplitude != 0) {
    limbs.emplace(rest, motion.wave, time, motion.film_length);
    set_flutter(motion.wave, time, motion.film_length, pose);
  }

  Current current(motion.wave, time, motion.film_length);
  float longest = std::max(rest.longest(), 1e-6f);
  float grown = std::min(pose.front, 1.0f);
  Pull food(motion.food, time, grown, longest);
  float ripen = static_cast<float>(motion.growth.ripen);
  float onset = smooth_step(0.0f, static_cast<float>(kOnset), pose.front);
  bool pulled = food.bends();
  std::vector<Quat> pull(pulled ? n : 0);
  pose.stretch.assign(food.stretches() ? n : 0, 1.0f);

  for (std::size_t i = 0; i < n; ++i) {
    float share = rest.distance[i] / longest;
    assert(rest.parent[i] < static_cast<std::int32_t>(i) && "parents precede children");
    std::int32_t p = rest.parent[i];
    Quat swing = wind              ? wind->turn(i, pose.turn)
                 : limbs           ? limbs->turn(i, pose.turn)
                 : current.still() ? Quat(1, 0, 0, 0)
                                   : current.turn(rest.position[i], share);
    float born = std::min(rest.birth[i], pose.front);
    if (p == Skeleton::kRoot) {
      if (pulled) pull[i] = Quat(1, 0, 0, 0);
      pose.turn[i] = swing;
      pose.position[i] = rest.position[i];
      if (wind && i > 0) carry_broken(rest, *motion.sway, i, pose);
    } else {
      Vec3 segment = rest.position[i] - rest.position[p];
      if (pulled) {
        Vec3 moved = pull[p] * (swing * segment);
        float length = glm::length(moved), step = (rest.distance[i] - rest.distance[p]) / longest;
        Quat more = length > 0 ? food.turn(moved / length, pose.position[p], share, step) : Quat(1, 0, 0, 0);
        pull[i] = glm::normalize(more * pull[p]);
        swing = pull[i] * swing;
      }
      Vec3 posed = swing * segment;
      if (!pose.stretch.empty()) pose.stretch[i] = stretch(food, pose.position[p], share, posed, swing);
      pose.turn[i] = swing;
      float reached = reached_share(rest, i, p, pose.front, born);
      pose.position[i] = pose.position[p] + reached * posed;
    }
    float age = std::max(pose.front - born, 0.0f);
    float young = kYoungRadius + (1 - kYoungRadius) * smooth_step(0.0f, ripen, age);
    set_radius(i, p, rest.radius[i] * onset * young, pose);
  }
}

}  // namespace frond
