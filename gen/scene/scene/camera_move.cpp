#include "scene/camera_move.h"

#include <algorithm>
#include <cmath>

#include "core/loop.h"

namespace frond {

namespace {

constexpr double kGolden = 1.6180339887;
constexpr int kSwings = 3;
constexpr double kKeysASwing = 12;
constexpr int kMostKeys = 20'000;

/// Seconds from one keyframe to the next.
double key_step(const CameraMove& move, const Film& film) {
  double step = 0.5 / film.fps;
  if (move.shake && move.shake->frequency > 0)
    step = std::min(step, 1 / (kKeysASwing * move.shake->frequency * std::pow(kGolden, kSwings - 1)));
  return std::max(step, film.length() / kMostKeys);
}

/// Where it stands on rail and orbit at a time.
Vec3 on_track(const Camera& camera, double time, double share) {
  const CameraMove& move = *camera.move;
  Vec3 at = camera.location.at(time);
  auto way = static_cast<float>(share);
  if (move.rail) at += way * (move.rail->to - camera.location.at(0));
  if (move.orbit) {
    const Orbit& orbit = *move.orbit;
    Vec3 center = orbit.center.value_or(camera.look_at.at(time));
    Quat turn = glm::angleAxis(static_cast<float>(orbit.turn) * way, Vec3(0, 1, 0));
    at = center + turn * (at - center) + Vec3(0, static_cast<float>(orbit.rise) * way, 0);
  }
  return at;
}

/// A place that is looked at from another, turned sideways and up about that by so many radians.
Vec3 turned_aside(Vec3 from, Vec3 to, Vec2 by) {
  Vec3 ahead = to - from, level = glm::cross(ahead, Vec3(0, 1, 0));
  Vec3 right = glm::length(level) > 1e-6f ? glm::normalize(level) : Vec3(1, 0, 0);
  Vec3 up = glm::normalize(glm::cross(right, ahead));
  return from + glm::angleAxis(by.y, right) * (glm::angleAxis(-by.x, up) * ahead);
}

}  // namespace

Vec2 shaken(const Shake& shake, double time, double film_length) {
  Vec2 sum(0);
  double weight = 1, all = 0;
  for (int i = 0; i < kSwings; ++i, weight /= kGolden) {
    double rate = looping_rate(shake.frequency * std::pow(kGolden, i), shake.loop ? film_length : 0);
    double phase = 2 * kPi * (rate * time + 0.29 * i);
    // The other direction by other phases, so that it goes along no line.
    sum += static_cast<float>(weight) * Vec2(std::sin(phase), std::sin(phase + 1.9 + i));
    all += weight;
  }
  return sum * static_cast<float>(shake.amplitude / all);
}

Camera keyed_move(const Camera& camera, const Film& film) {
  Camera result = camera;
  result.move.reset();
  if (!camera.move || film.frames == 1) return result;
  const CameraMove& move = *camera.move;
  double length = film.length(), step = key_step(move, film);
  // Keyframes rest at their ends, which therefore lie outside of the film.
  int last = static_cast<int>(std::ceil(length / step)) + 2;
  std::vector<Animated<Vec3>::Key> location, look_at;
  for (int i = -2; i <= last; ++i) {
    double time = i * step, share = time / length;
    if (move.ease != Ease::none) share = std::clamp(share, 0.0, 1.0);
    Vec3 at = on_track(camera, time, eased(move.ease, share)), to = camera.look_at.at(time);
    if (move.shake) to = turned_aside(at, to, shaken(*move.shake, time, length));
    location.push_back({time, at}), look_at.push_back({time, to});
  }
  if (move.orbit || move.rail) result.location = Animated<Vec3>(std::move(location));
  if (move.shake) result.look_at = Animated<Vec3>(std::move(look_at));
  return result;
}

}  // namespace frond
