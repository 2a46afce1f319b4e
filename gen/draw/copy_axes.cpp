#include "draw/copy_axes.h"

#include <cmath>

#include "core/loop.h"
#include "core/seed.h"
#include "motion/motion.h"

namespace frond {

namespace {

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

}  // namespace

bool sways(const SownStand& stand, const Film& film) {
  return stand.dress.motion.wave.amplitude > 0 && film.frames > 1;
}

glm::mat3 copy_axes(const SownStand& stand, const Film& film, std::size_t i, double time) {
  glm::mat3 axes = glm::mat3_cast(stand.copies.turn_at(i, time));
  if (!sways(stand, film)) return axes;
  Vec2 lean = bent(stand.dress.motion.wave, film.length(), stand.copies.foot[i], time);
  for (int axis = 0; axis < 3; ++axis) axes[axis] += Vec3(lean.x, 0, lean.y) * axes[axis].y;
  return axes;
}

}  // namespace frond
