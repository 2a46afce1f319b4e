#include "grove/uproot.h"

#include "grove/shoots.h"

namespace frond {

namespace {

constexpr float kAfterStorm = 1.95f;  // years from the beginning of the year; by 1.9 all is down

}  // namespace

double held_moment(const Metamers& t, const Species& s) {
  double volume = 0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    double r = pipe_radius(s.wood, t.pipe[i]);
    if (t.order[i] == 0) volume += kPi * r * r * t.length(i);
  }
  return s.anchorage * s.wood.density * volume;
}

Uprooting uprooting_of(const Metamers& t, const Species& s, const Weather& storm, int year) {
  if (s.anchorage <= 0 || t.size() < 2) return {};
  std::vector<float> radius(t.size()), leaves(t.size());
  for (std::size_t i = 0; i < t.size(); ++i) {
    radius[i] = pipe_radius(s.wood, t.pipe[i]);
    leaves[i] = bears_leaves(t, s, i, year) ? static_cast<float>(s.leaf_area) : 0.0f;
  }
  Vec3 moment = moment_at_foot({t.tip, t.parent, radius, leaves}, s.wood, storm);
  float size = glm::length(moment);
  auto hold = static_cast<float>(held_moment(t, s));
  if (size <= hold) return {};
  return {static_cast<float>(year) + kAfterStorm, glm::cross(moment / size, Vec3(0, 1, 0)), size, hold};
}

void die(Metamers& t, float time) {
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t.has(i, Metamers::dead)) continue;
    t.died[i] = time;
    t.set(i, Metamers::dead);
  }
}

}  // namespace frond
