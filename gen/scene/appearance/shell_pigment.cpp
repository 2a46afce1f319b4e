#include "appearance/shell_pigment.h"

#include <algorithm>
#include <vector>

namespace frond {

namespace {

/// The constants of Meinhardt's equations, those of time for one step.
struct Kinetics {
  float spread = 0.02f, substrate_spread = 0;              // Da, Ds; cells squared
  float supply = 0.02f, loss = 0.0033f;                    // of substrate: b, v
  float decay = 0.1f, basic = 0.004f, saturation = 0.25f;  // m, r0, k
  float uneven = 0.05f;                                    // how much cells differ in r
  double fires = 0;                                        // by chance, in ten cells and a line
  float fades = 0;                                         // share of the pigment that is left a line later
  int steps = 6;                                           // for a line
};

constexpr float kRate = 0.1f;  // r
constexpr int kBefore = 160;   // lines that are laid before the first that is kept

Kinetics kinetics(ShellPattern pattern) {
  switch (pattern) {
    case ShellPattern::stripes:
      return {.spread = 0.03f,
              .substrate_spread = 0.4f,
              .supply = 0.05f,
              .loss = 0,
              .basic = 0.01f,
              .saturation = 0.1f,
              .uneven = 0.6f};
    case ShellPattern::axial:
      return {.spread = 0.1f, .supply = 0.06f, .loss = 0, .basic = 0.0025f, .uneven = 0.1f, .steps = 8};
    case ShellPattern::zigzag:
      return {.supply = 0.10f, .loss = 0.0164f, .fires = 0.006};
    case ShellPattern::tents:
      return {.spread = 0.03f, .supply = 0.07f, .loss = 0.0115f, .fires = 0.006, .fades = 0.94f, .steps = 5};
    case ShellPattern::spots:
      return {.spread = 0.05f, .substrate_spread = 0.3f, .uneven = 0.3f, .fires = 0.05, .steps = 4};
    default:
      return {};
  }
}

}  // namespace

Grid pigment(ShellPattern pattern, int width, int lines, Seed seed) {
  Kinetics law = kinetics(pattern);
  auto n = static_cast<std::size_t>(width);
  // The edge is a ring, as the mantle's is not; but so no seam is seen.
  std::vector<float> rate(n), a(n, 0), s(n, law.loss > 0 ? law.supply / law.loss : 1), next_a(n), next_s(n),
      left(n, 0);
  for (std::size_t i = 0; i < n; ++i)
    rate[i] = kRate * static_cast<float>(1 + law.uneven * seed.child("rate", i).range(-1, 1));
  Grid grid(width, lines);
  for (int line = -kBefore; line < lines; ++line) {
    Seed chance = seed.child("fire", static_cast<std::uint64_t>(line + kBefore));
    for (std::uint64_t k = 0; k < static_cast<std::uint64_t>(width) / 10 * (law.fires > 0); ++k) {
      Seed one = chance.child(k);
      if (one.unit() > law.fires) continue;
      auto at = static_cast<std::size_t>(one.child("at").unit() * width);
      for (std::size_t i = 0; i < 5; ++i) a[(at + i) % n] += 2;
    }
    for (int step = 0; step < law.steps; ++step) {
      for (std::size_t i = 0; i < n; ++i) {
        std::size_t before = i > 0 ? i - 1 : n - 1, after = i + 1 < n ? i + 1 : 0;
        float made = rate[i] * s[i] * (a[i] * a[i] / (1 + law.saturation * a[i] * a[i]) + law.basic);
        next_a[i] = a[i] + made - law.decay * a[i] + law.spread * (a[before] + a[after] - 2 * a[i]);
        next_s[i] = std::max(0.0f, s[i] + law.supply - made - law.loss * s[i] +
                                       law.substrate_spread * (s[before] + s[after] - 2 * s[i]));
      }
      std::swap(a, next_a), std::swap(s, next_s);
    }
    for (std::size_t i = 0; i < n; ++i) {
      left[i] = std::max(a[i], law.fades * left[i]);
      if (line >= 0) grid.at(static_cast<int>(i), lines - 1 - line) = std::clamp(0.55f * left[i], 0.0f, 1.0f);
    }
  }
  return grid;
}

}  // namespace frond
