#include "grove/wood.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "model/drag.h"

namespace frond {

namespace {

constexpr float kMostBend = 0.5f;  // radians that one internode may sag

/// Forces above a place, with their moments about the origin.
struct Load {
  Vec3 force{0}, moment{0};
  void add(Vec3 f, Vec3 at) {
    force += f;
    moment += glm::cross(at, f);
  }
  void add(const Load& other) {
    force += other.force;
    moment += other.moment;
  }
  /// The moment about a place.
  Vec3 about(Vec3 at) const { return moment - glm::cross(at, force); }
};

/// The load of an internode by its own weight, that of its leaves and of snow, and wind. `height` is that of
/// its middle above ground, metres.
Load load_of(Vec3 from, Vec3 to, float height, float radius, float leaf_area, const Wood& wood,
             const Weather& weather) {
  Vec3 offset = to - from, middle = (from + to) / 2.0f;
  float length = glm::length(offset);
  auto density = static_cast<float>(wood.density), pi = static_cast<float>(kPi);
  float mass = density * pi * radius * radius * length + static_cast<float>(wood.leaf_mass) * leaf_area;
  float level = std::sqrt(offset.x * offset.x + offset.z * offset.z);
  mass += static_cast<float>(weather.snow) * (2 * radius * level + kSunlit * leaf_area);
  Load load;
  load.add(Vec3(0, -mass * static_cast<float>(kGravity), 0), middle);
  float speed = glm::length(weather.wind);
  if (speed > 0) {
    float across = glm::length(glm::cross(offset, weather.wind)) / speed;
    float here = wind_at(height, speed), give = std::pow(std::max(here / kCalm, 1.0f), -kGiving);
    float area = kBareDrag * 2 * radius * across + kLeafDrag * give * kSunlit * leaf_area;
    load.add(weather.wind * (0.5f * kAir * here * here / speed * area), middle);
  }
  return load;
}

Load load_at(const Limbs& limbs, std::size_t i, const Wood& wood, const Weather& weather) {
  Vec3 foot = limbs.tip[limbs.parent[i]];
  float height = (foot.y + limbs.tip[i].y) / 2 - limbs.tip[0].y;
  return load_of(foot, limbs.tip[i], height, limbs.radius[i], limbs.leaf_area[i], wood, weather);
}

float bent(Vec3 moment, Vec3 axis) {
  float length = glm::length(axis);
  if (length < 1e-9f) return glm::length(moment);
  axis /= length;
  return glm::length(moment - axis * glm::dot(moment, axis));  // what is along the axis only twists
}

}  // namespace

std::vector<float> bending_stress(const Limbs& limbs, const Wood& wood, const Weather& weather) {
  assert(limbs.parent.size() == limbs.tip.size() && limbs.radius.size() == limbs.tip.size());
  assert(limbs.leaf_area.size() == limbs.tip.size());
  std::size_t n = limbs.tip.size();
  std::vector<Load> load(n);
  std::vector<float> stress(n);
  for (std::size_t i = n; i-- > 0;) {
    std::int32_t p = limbs.parent[i];
    if (p < 0) continue;
    assert(p < static_cast<std::int32_t>(i) && limbs.radius[i] > 0);
    Vec3 foot = limbs.tip[p];
    load[i].add(load_at(limbs, i, wood, weather));
    float r = limbs.radius[i], moment = bent(load[i].about(foot), limbs.tip[i] - foot);
    stress[i] = 4 * moment / (static_cast<float>(kPi) * r * r * r);
    load[p].add(load[i]);
  }
  return stress;
}

Vec3 moment_at_foot(const Limbs& limbs, const Wood& wood, const Weather& weather) {
  Load load;
  for (std::size_t i = 1; i < limbs.tip.size(); ++i) load.add(load_at(limbs, i, wood, weather));
  Vec3 moment = limbs.tip.empty() ? Vec3(0) : load.about(limbs.tip[0]);
  return Vec3(moment.x, 0, moment.z);
}

void thicken(Metamers& t) {
  std::vector<float> carried(t.size(), 0.0f);
  for (std::size_t i = t.size(); i-- > 0;) {
    float now = carried[i] > 0 ? carried[i] + kLeafPipe : 1.0f;
    t.pipe[i] = std::max(t.pipe[i], now);
    if (t.parent[i] != Metamers::kRoot) carried[t.parent[i]] += t.pipe[i];
  }
}

float pipe_radius(const Wood& wood, float pipe) {
  assert(wood.exponent > 0 && wood.twig_radius > 0);
  return static_cast<float>(wood.twig_radius) *
         std::pow(std::max(pipe, 1e-6f), 1 / static_cast<float>(wood.exponent));
}

void sag(Metamers& t, const Wood& wood, double leaf_area, std::size_t first, bool tied) {
  assert(first <= t.size() && wood.stiffness > 0);
  std::size_t n = t.size() - first;
  std::vector<Load> load(n);
  std::vector<Quat> turn(n, Quat(1, 0, 0, 0));
  std::vector<Vec3> offset(n);
  for (std::size_t k = n; k-- > 0;) {
    std::size_t i = first + k;
    auto p = static_cast<std::size_t>(t.parent[i]);
    float r = pipe_radius(wood, t.pipe[i]);
    offset[k] = t.tip[i] - t.tip[p];
    load[k].add(load_of(t.tip[p], t.tip[i], 0, r, static_cast<float>(leaf_area), wood, {}));
    Vec3 moment = load[k].about(t.tip[p]);
    float inertia = static_cast<float>(kPi) / 4 * r * r * r * r, size = glm::length(moment);
    float angle = size * glm::length(offset[k]) / (static_cast<float>(wood.stiffness) * inertia);
    if (tied && t.order[i] == 0) continue;
    if (size > 1e-9f) turn[k] = glm::angleAxis(std::min(angle, kMostBend), moment / size);
    if (p >= first) load[p - first].add(load[k]);
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t i = first + k;
    auto p = static_cast<std::size_t>(t.parent[i]);
    if (p >= first) turn[k] = glm::normalize(turn[p - first] * turn[k]);
    Vec3 moved = turn[k] * offset[k];
    // A shoot hangs down, it does not swing past that.
    if (t.tip[p].y + moved.y < t.tip[0].y + 0.05f) moved.y = std::max(moved.y, 0.0f);
    t.tip[i] = t.tip[p] + moved;
    t.side[i] = turn[k] * t.side[i];
  }
}

}  // namespace frond
