#include "land/hills.h"

#include <algorithm>
#include <cmath>

#include "core/noise.h"

namespace frond {

namespace {

constexpr double kBaseDetail = 0.12;  // of the size of hills, spacing that shows those which water then wears
constexpr double kFirstGully = 0.24;  // of the size of hills, from spur to spur of the largest
constexpr double kGullyDepth = 0.11;  // height of these, in the units of the noise
constexpr double kNarrower = 0.5, kShallower = 0.44;  // from one octave to the next
constexpr int kGullyOctaves = 7;
constexpr double kSlopeOver = 0.06;  // of the size of hills, over which their slope is measured
constexpr double kTurning = 0.9;  // slope below which furrows grow wide, as their direction turns fast there

struct Furrow {
  double height = 0;  // -1..1, sharp above
  Vec2 slope{0};      // its gradient
};

/// Furrows one unit apart that run at right angles to `across`, of length 1 or less. Waves of the cells of a
/// grid are mixed by their phase (Tricard et al. 2019, procedural phasor noise), so that all are of one depth
/// and meet in forks.
Furrow furrows(Vec2 at, Vec2 across, Seed seed) {
  constexpr float kReach = 1.2f;  // of a cell's wave: beyond the next cell there is none
  auto column = static_cast<std::int64_t>(std::floor(at.x)),
       row = static_cast<std::int64_t>(std::floor(at.y));
  float cosine = 0, sine = 0;
  for (std::int64_t j = row - 1; j <= row + 1; ++j)
    for (std::int64_t i = column - 1; i <= column + 1; ++i) {
      Seed cell = seed.child(static_cast<std::uint64_t>(j + 1'000'000))
                      .child(static_cast<std::uint64_t>(i + 1'000'000));
      Vec2 middle(static_cast<double>(i) + cell.child(0).range(0.2, 0.8),
                  static_cast<double>(j) + cell.child(1).range(0.2, 0.8));
      Vec2 from = at - middle;
      float inside = 1 - glm::dot(from, from) / (kReach * kReach);
      if (inside <= 0) continue;
      float weight = inside * inside * inside, phase = static_cast<float>(2 * kPi) * glm::dot(from, across);
      cosine += weight * std::cos(phase), sine += weight * std::sin(phase);
    }
  float length = std::sqrt(cosine * cosine + sine * sine + 0.01f);
  // As a crest: 1 - 2 |sin(phase / 2)|, a little rounded.
  double half = 0.5 * (1 - static_cast<double>(cosine / length)), bow = std::sqrt(half + 0.006);
  double steep = static_cast<double>(sine / length) / (2 * bow);
  return {1 - 2 * bow, across * static_cast<float>(-2 * kPi * steep)};
}

}  // namespace

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

double eroded_hill_noise(Vec2 at, double hill_size, double rough, double erosion, double spacing, Seed seed) {
  if (erosion <= 0) return hill_noise(at, hill_size, rough, spacing, seed);
  double detail = std::max(spacing, kBaseDetail * hill_size);
  auto base = [&](Vec2 p) { return hill_noise(p, hill_size, rough, detail, seed); };
  // As wide as shows no steps of the floats that noise is worked out with.
  auto step = static_cast<float>(kSlopeOver * hill_size);
  double sum = base(at);
  // Slope in units of the noise over the size of a hill.
  Vec2 slope =
      Vec2(base(at + Vec2(step, 0)) - sum, base(at + Vec2(0, step)) - sum) / static_cast<float>(kSlopeOver);
  double wide = kFirstGully * hill_size, deep = kGullyDepth * erosion;
  Seed gullies = seed.child("gullies");
  for (std::uint64_t octave = 0; octave < kGullyOctaves; ++octave, wide *= kNarrower, deep *= kShallower) {
    double shown = smooth_step(2 * spacing, 4 * spacing, wide);
    if (shown <= 0) break;
    // On level ground nothing is washed out.
    double steep = glm::length(slope), washed = smooth_step(0.1, 2.0, steep) * shown;
    Vec2 across = Vec2(-slope.y, slope.x) / static_cast<float>(std::max(steep, kTurning));
    Furrow furrow = furrows(at / static_cast<float>(wide), across, gullies.child(octave));
    sum += deep * washed * furrow.height;
    slope += furrow.slope * static_cast<float>(deep * washed * hill_size / wide);
  }
  return sum;
}

}  // namespace frond
