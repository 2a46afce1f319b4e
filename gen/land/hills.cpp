#include "land/hills.h"

#include <algorithm>
#include <cmath>

#include "core/noise.h"

namespace frond {

double hill_noise(Vec2 at, double hill_size, double rough, double spacing, Seed seed) {
  auto shift = [&](const char* name) { return static_cast<float>(seed.child(name).range(-99, 99)); };
  Vec2 p = at * static_cast<float>(0.8 / hill_size) + Vec2(shift("x"), shift("z"));
  // Bent, so that valleys wind.
  p += 0.22f * Vec2(noise(Vec3(0.9f * p.x, 31, 0.9f * p.y)), noise(Vec3(0.9f * p.x, 57, 0.9f * p.y)));
  double sum = 0, strength = 1, carry = 1, wide = hill_size;
  for (int octave = 0; octave < 9; ++octave, wide /= 2) {
    double shown = smooth_step(2 * spacing, 4 * spacing, wide);
    if (shown <= 0) break;
    double n = noise(Vec3(p.x, 7 * octave, p.y)), crest = 1.1 - 2.2 * std::sqrt(n * n + 0.02);
    double value = n + 0.75 * rough * (crest - n);
    sum += strength * carry * shown * value;
    carry *= std::clamp(0.55 + 0.6 * value, 0.15, 1.0);
    strength *= 0.30 + 0.26 * rough;
    p = 2.0f * Vec2(0.8f * p.x - 0.6f * p.y, 0.6f * p.x + 0.8f * p.y);  // turned, too
  }
  return sum;
}

}  // namespace frond
