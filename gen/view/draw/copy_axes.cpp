#include "draw/copy_axes.h"

#include <cmath>
#include <complex>

#include "core/loop.h"
#include "core/seed.h"
#include "motion/motion.h"

namespace frond {

namespace {

/// How what nobody weighs answers to the wind.
struct CopySway {
  double swings = 1;     // a second
  double damping = 0.1;  // of the critical damping
  double give = 1e-3;    // metres a metre of height for each pascal
};
// What Moore and Maguire (2004) found for trees of 20 m, and a lean of a tenth in a wind of 20 m/s. Herbs: as
// crops (de Langre 2008), in the slower wind near the ground.
constexpr CopySway kTree{0.35, 0.12, 8e-4}, kHerb{1.6, 0.18, 4e-3};

/// How far the wind bends something at a place over, as a shear: metres a metre of height.
Vec2 bent(const Wave& wave, double film_length, Vec3 at, double time) {
  Vec2 wind(wave.direction.x, wave.direction.z);
  wind = glm::length(wind) > 1e-6f ? glm::normalize(wind) : Vec2(1, 0);
  double speed = wave.loop ? looping_rate(wave.speed, film_length) : wave.speed;
  double along = glm::dot(Vec2(at.x, at.z), wind) / wave.length;
  double own =
      Seed{static_cast<std::uint64_t>(std::llround(at.x * 100) * 65537 + std::llround(at.z * 100))}.unit();
  double swing = std::sin(2 * kPi * (speed * time - along + 0.15 * own) + wave.phase);
  double side = std::sin(2 * kPi * (speed * time - along + own) + wave.phase);
  auto reach = static_cast<float>(0.25 * wave.amplitude);
  return wind * (reach * static_cast<float>(swing)) +
         Vec2(-wind.y, wind.x) * (0.4f * reach * static_cast<float>(side));
}

/// The lean of a copy in the wind, as that shear.
Vec2 blown(const WindField& wind, const CopySway& sway, Vec3 at, double time) {
  double mean = wind.mean(time), swing = 0;
  for (const Gust& g : wind.gusts) {
    std::complex<double> push =
        std::polar(g.share, g.rate * time - g.wave.x * at.x - g.wave.y * at.z + g.phase);
    swing += (push * transfer({2 * kPi * sway.swings, sway.damping}, g.rate)).real();
  }
  double lean = sway.give * drag_pressure(mean) * (1 + drag_power(mean) * swing);
  return Vec2(wind.along.x, wind.along.z) * static_cast<float>(lean / (1 + std::abs(lean)));
}

}  // namespace

bool sways(const CopySet& set, const Film& film) {
  return (set.appearance.motion.wave.amplitude > 0 || set.wind) && film.frames > 1;
}

glm::mat3 copy_axes(const CopySet& set, const Film& film, std::size_t i, double time) {
  glm::mat3 axes = glm::mat3_cast(set.copies.turn_at(i, time));
  if (!sways(set, film)) return axes;
  Vec3 foot = set.copies.foot[i];
  const Motion& motion = set.appearance.motion;
  Vec2 lean = set.wind ? blown(*set.wind, motion.wood ? kTree : kHerb, foot, time)
                       : bent(motion.wave, film.length(), foot, time);
  for (int axis = 0; axis < 3; ++axis) axes[axis] += Vec3(lean.x, 0, lean.y) * axes[axis].y;
  return axes;
}

}  // namespace frond
