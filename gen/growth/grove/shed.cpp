#include "grove/shed.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "grove/shoots.h"

namespace frond {

namespace {

constexpr double kSpared = 2;          // years in which a new branch is not judged
constexpr double kWholeTree = 0.35;    // a tree lives on with so much of the light that a branch needs
constexpr float kUsedStrength = 0.4f;  // of a stem's strength, in an ordinary storm
constexpr float kMostWidening = 1.4f;  // of a stem in a year
constexpr float kClearShare = 0.32f;   // of the height up to which a stem with a clear trunk is bare by then

float height_of(const Metamers& t) {
  float top = 0;
  for (std::size_t i = 0; i < t.size(); ++i)
    if (!t.has(i, Metamers::dead)) top = std::max(top, t.tip[i].y - t.tip[0].y);
  return top;
}

/// Years after its death that wood of a radius still stands.
float stands_dead(const Wood& wood, float radius) {
  return static_cast<float>(wood.deadwood) * std::sqrt(radius / static_cast<float>(wood.twig_radius));
}

}  // namespace

std::size_t die_of_shade(Metamers& t, const Species& s, Seed seed, int year, double age) {
  assert(t.size() > 0 && t.to_leader.size() == t.size() && t.count.size() == t.size());
  std::size_t n = t.size(), died = 0;
  float bare =
      s.clear_trunk > 0 ? std::min(static_cast<float>(s.clear_trunk), kClearShare * height_of(t)) : 0;
  auto least = static_cast<float>(s.least_light());
  auto mean = [&](std::size_t i) { return (t.to_leader[i] + t.to_side[i]) / std::max(t.count[i], 1.0f); };
  bool ends = age >= s.lifespan || (age >= kSpared && mean(0) < kWholeTree * least);
  for (std::size_t i = 0; i < n; ++i) {
    if (t.has(i, Metamers::dead)) continue;
    std::int32_t p = t.parent[i];
    float time = Metamers::kNever;
    if (p != Metamers::kRoot && t.has(p, Metamers::dead)) {
      time = t.died[p];
    } else if (i == 0 ? ends
                      : t.has(i, Metamers::side_shoot) && year - std::floor(t.born[i] - 0.001) >= kSpared) {
      bool low = i > 0 && t.order[p] == 0 && t.tip[p].y - t.tip[0].y < bare;
      if (i == 0 || low || mean(i) < least)
        time = static_cast<float>(year + seed.child(t.serial[i]).child(11).unit());
    }
    if (time == Metamers::kNever) continue;
    t.died[i] = std::max(time, t.born[i]);
    t.flags[i] =
        static_cast<std::uint8_t>((t.flags[i] & (Metamers::side_shoot | Metamers::regrown)) | Metamers::dead);
    ++died;
  }
  return died;
}

Strain strain_of(const Metamers& t, const Species& s, const Weather& storm, int year) {
  std::size_t n = t.size();
  Strain strain;
  strain.radius.resize(n);
  std::vector<float> leaves(n), reach(n, 0.0f);  // reach: to the farthest tip
  for (std::size_t i = 0; i < n; ++i) {
    strain.radius[i] = pipe_radius(s.wood, t.pipe[i]);
    leaves[i] = bears_leaves(t, s, i, year) ? static_cast<float>(s.leaf_area) : 0.0f;
  }
  strain.stress = bending_stress({t.tip, t.parent, strain.radius, leaves}, s.wood, storm);
  auto stiff = static_cast<float>(kPi / 2 * s.wood.stiffness);
  for (std::size_t i = n; i-- > 1;) {
    std::int32_t p = t.parent[i];
    reach[i] += t.length(i);
    assert(strain.radius[i] > 0 && std::isfinite(strain.stress[i]));
    reach[p] = std::max(reach[p], reach[i]);
    // No load bends a branch more than over a quarter of a circle.
    strain.stress[i] = std::min(strain.stress[i], stiff * strain.radius[i] / std::max(reach[i], 1e-3f));
  }
  return strain;
}

void brace(Metamers& t, const Wood& wood, Strain& strain) {
  assert(strain.radius.size() == t.size() && strain.stress.size() == t.size());
  auto most = static_cast<float>(kUsedStrength * wood.strength);
  float below = 0;
  for (std::size_t i = t.size(); i-- > 1;) {
    if (t.order[i] > 0 || t.has(i, Metamers::dead)) continue;
    if (strain.stress[i] > most) {
      float wider = std::min(std::cbrt(strain.stress[i] / most), kMostWidening);
      t.pipe[i] *= std::pow(wider, static_cast<float>(wood.exponent));
      strain.radius[i] *= wider;
      strain.stress[i] /= wider * wider * wider;
    }
    below = t.pipe[i] = std::max(t.pipe[i], below);
  }
}

Falls find_falls(const Metamers& t, const Species& s, const Strain& strain, Seed seed, int year) {
  assert(strain.radius.size() == t.size() && strain.stress.size() == t.size());
  std::size_t n = t.size();
  Falls falls;
  falls.time.assign(n, Metamers::kNever);
  std::vector<std::uint32_t> above(n, 1);
  for (std::size_t i = n; i-- > 1;) above[t.parent[i]] += above[i];
  for (std::size_t i = 1; i < n; ++i) {
    std::int32_t p = t.parent[i];
    if (falls.time[p] != Metamers::kNever) {
      falls.time[i] = falls.time[p];
      continue;
    }
    bool dead = t.has(i, Metamers::dead);
    float sound = 1;
    if (dead) sound = 1 - (static_cast<float>(year + 1) - t.died[i]) / stands_dead(s.wood, strain.radius[i]);
    bool bends = strain.stress[i] > sound * static_cast<float>(s.wood.strength);
    if (sound > 0 && !bends) continue;
    falls.time[i] = static_cast<float>(year + 1 + 0.9 * seed.child(t.serial[i]).child(12).unit());
    if (!dead) {
      ++falls.broken;
      falls.stem = falls.stem || 2 * above[i] > n;
    }
  }
  return falls;
}

}  // namespace frond
