#include "scene/camera.h"

#include <algorithm>
#include <cmath>

namespace frond {

namespace {

constexpr double kStep = 0.08;  // seconds between keyframes
constexpr int kMostSteps = 4000;
constexpr float kSmooth = 1.2f;  // metres about

float ground_about(const Heights& heights, Vec3 at) {
  double sum = 0;
  for (float x : {-kSmooth, 0.0f, kSmooth})
    for (float z : {-kSmooth, 0.0f, kSmooth}) sum += heights(at.x + x, at.z + z);
  return static_cast<float>(sum / 9);
}

Animated<Vec3> raised(const Animated<Vec3>& path, const Heights& heights) {
  double first = path.keys().front().time, last = path.keys().back().time;
  int steps = std::clamp(static_cast<int>(std::ceil((last - first) / kStep)), 0, kMostSteps);
  steps = std::max(steps, static_cast<int>(path.keys().size()) - 1);
  std::vector<Animated<Vec3>::Key> keys;
  for (int i = 0; i <= steps; ++i) {
    double time = first + (steps > 0 ? (last - first) * i / steps : 0);
    Vec3 at = path.at(time);
    keys.push_back({time, at + Vec3(0, ground_about(heights, at), 0)});
  }
  return Animated<Vec3>(std::move(keys));
}

}  // namespace

Camera over_ground(const Camera& camera, const Heights& heights) {
  Camera moved = camera;
  moved.location = raised(camera.location, heights);
  moved.look_at = raised(camera.look_at, heights);
  if (camera.focus && camera.focus->organism.empty())
    moved.focus->point = raised(camera.focus->point, heights);
  return moved;
}

Vec3 Lens::seen(Vec3 place) const {
  Vec3 to = place - at;
  float depth = glm::dot(to, toward);
  return {glm::dot(to, right) / (wide * depth), glm::dot(to, up) / (high * depth), depth};
}

Lens lens_at(const Camera& camera, double time, double aspect) {
  Lens lens;
  lens.at = camera.location.at(time);
  lens.toward = glm::normalize(camera.look_at.at(time) - lens.at);
  Vec3 sky = sky_axis(lens.toward);
  lens.right = glm::normalize(glm::cross(lens.toward, sky));
  lens.up = glm::cross(lens.right, lens.toward);
  lens.wide = static_cast<float>(std::tan(radians(camera.angle.at(time)) / 2));
  lens.high = lens.wide * static_cast<float>(aspect);
  return lens;
}

std::pair<Vec2, double> seen_ground(const Camera& camera, double length) {
  constexpr float kAhead = 5;  // metres
  auto level = [](Vec3 p) { return Vec2(p.x, p.z); };
  auto ahead = [&](double time) {
    Vec2 at = level(camera.location.at(time)), offset = level(camera.look_at.at(time)) - at;
    float far = glm::length(offset);
    return far > kAhead ? at + offset * (kAhead / far) : at + offset;
  };
  Vec2 middle = (ahead(0) + ahead(length / 2) + ahead(length)) / 3.0f;
  double reach = 0;
  for (double share : {0.0, 0.25, 0.5, 0.75, 1.0})
    reach = std::max<double>(reach, glm::distance(middle, level(camera.location.at(share * length))));
  return {middle, reach};
}

}  // namespace frond
