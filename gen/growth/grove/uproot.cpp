#include "grove/uproot.h"

#include "grove/shoots.h"

namespace frond {

namespace {

constexpr float kAfterStorm = 1.95f;  // years from the beginning of the year; by 1.9 all is down

constexpr double kHinge = 20;   // N m a kg of stem: what the wood holds that fellers leave uncut
constexpr double kWedge = 1.1;  // of that, by what drives it over

double stem_mass(const Metamers& t, const Wood& wood) {
  double volume = 0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    double r = pipe_radius(wood, t.pipe[i]);
    if (t.order[i] == 0) volume += kPi * r * r * t.length(i);
  }
  return wood.density * volume;
}

/// The moment of all loads about the foot in some weather.
Vec3 load_moment(const Metamers& t, const Species& s, const Weather& weather, int year) {
  std::vector<float> radius(t.size()), leaves(t.size());
  for (std::size_t i = 0; i < t.size(); ++i) {
    radius[i] = pipe_radius(s.wood, t.pipe[i]);
    leaves[i] = bears_leaves(t, s, i, year) ? static_cast<float>(s.leaf_area) : 0.0f;
  }
  return moment_at_foot({t.tip, t.parent, radius, leaves}, s.wood, weather);
}

}  // namespace

double held_moment(const Metamers& t, const Species& s) { return s.anchorage * stem_mass(t, s.wood); }

Uprooting uprooting_of(const Metamers& t, const Species& s, const Weather& storm, int year) {
  if (s.anchorage <= 0 || t.size() < 2) return {};
  Vec3 moment = load_moment(t, s, storm, year);
  float size = glm::length(moment);
  auto hold = static_cast<float>(held_moment(t, s));
  if (size <= hold) return {};
  return {static_cast<float>(year) + kAfterStorm, glm::cross(moment / size, Vec3(0, 1, 0)), size, hold};
}

Uprooting felling_of(const Metamers& t, const Species& s, std::optional<Vec3> toward, int year) {
  Vec3 lean = glm::cross(load_moment(t, s, {}, year), Vec3(0, 1, 0));
  Vec3 side = toward.value_or(lean);
  side = glm::length(side) > 1e-6f ? glm::normalize(side) : Vec3(1, 0, 0);
  auto hold = static_cast<float>(kHinge * stem_mass(t, s.wood));
  return {static_cast<float>(year) + kAfterStorm, side, static_cast<float>(kWedge) * hold, hold, true};
}

void die(Metamers& t, float time) {
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t.has(i, Metamers::dead)) continue;
    t.died[i] = time;
    t.set(i, Metamers::dead);
  }
}

}  // namespace frond
