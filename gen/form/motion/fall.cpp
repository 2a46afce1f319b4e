#include "motion/fall.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace frond {

namespace {

constexpr double kRebound = 0.2;    // of the speed, that the ground gives back
constexpr double kRest = 0.02;      // radians a second: slower it lies still
constexpr double kLongest = 60;     // seconds
constexpr double kCalming = 1.5;    // seconds in which its swaying ends
constexpr float kAside = 0.3f;      // of its length: how far an internode that is pressed evades sideways
constexpr int kGroundSearches = 3;  // for the height of the ground where an internode comes to lie

/// An internode that ends `low` metres too deep, turned about its lower end until it does not. One that
/// points straight down evades to the `side`.
Vec3 pressed(Vec3 segment, float low, Vec3 side) {
  float length = glm::length(segment);
  if (length <= 0) return segment;
  float up = std::clamp(segment.y + low, -length, length);
  Vec3 flat(segment.x, 0, segment.z);
  flat += Vec3(side.x, 0, side.z) * (kAside * length * std::min(1.0f, low / (kAside * length)));
  float level = glm::length(flat);
  if (level < 1e-7f) return segment;
  return flat * (std::sqrt(length * length - up * up) / level) + Vec3(0, up, 0);
}

/// The sum of the moments at an angle, N m.
double moment_at(const Overturning& body, double angle) {
  double roots = body.excess + body.weight * std::sin(body.balance);
  return body.weight * std::sin(angle - body.balance) + roots * std::max(0.0, 1 - angle / body.torn);
}

}  // namespace

std::vector<float> course_of(const Overturning& body) {
  assert(body.inertia > 0 && body.torn > 0 && body.stop >= 0);
  double angle = 0, speed = 0;
  bool landed = false;
  std::vector<float> course{0};
  auto pull = [&](double at) { return moment_at(body, at) / body.inertia; };
  while (static_cast<double>(course.size()) * kFallStep < kLongest) {
    constexpr double h = kFallStep;
    double v1 = speed, a1 = pull(angle);
    double v2 = speed + h / 2 * a1, a2 = pull(angle + h / 2 * v1);
    double v3 = speed + h / 2 * a2, a3 = pull(angle + h / 2 * v2);
    double v4 = speed + h * a3, a4 = pull(angle + h * v3);
    angle += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    speed += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    if (angle >= body.stop) {
      angle = body.stop;
      speed *= -kRebound;
      landed = true;
    }
    bool still = landed ? angle == body.stop && -speed < kRest : speed <= 0;
    course.push_back(static_cast<float>(angle));
    if (still) break;
  }
  return course;
}

float Fall::angle(double time) const {
  if (course.empty() || time <= start) return 0;
  double step = (time - start) / kFallStep;
  auto last = static_cast<double>(course.size() - 1);
  if (step >= last) return course.back();
  auto k = static_cast<std::size_t>(step);
  return course[k] + (course[k + 1] - course[k]) * static_cast<float>(step - static_cast<double>(k));
}

double Fall::sway(double time) const { return 1 - smooth_step(start, start + kCalming, time); }

void turn_fallen(const Fall& fall, const Skeleton& rest, double time, const GroundHeight& ground,
                 Pose& pose) {
  float angle = fall.angle(time);
  if (angle == 0) return;
  const Quat turn = glm::angleAxis(angle, fall.axis);
  const std::vector<Vec3> upright = pose.position;
  std::vector<Quat> turned(rest.size(), Quat(1, 0, 0, 0));
  std::vector<std::uint8_t> falls(rest.size());
  for (std::size_t i = 0; i < rest.size(); ++i) {
    std::int32_t p = rest.parent[i];
    falls[i] = p == Skeleton::kRoot ? i == 0 : falls[p];
    if (!falls[i]) continue;
    turned[i] = p == Skeleton::kRoot ? turn : turned[p];
    if (p == Skeleton::kRoot) {
      pose.position[i] = fall.hinge + turn * (upright[i] - fall.hinge);
    } else {
      Vec3 at = rest.position[i], base = pose.position[p], segment = turned[p] * (upright[i] - upright[p]);
      float over = std::min(pose.radius[i], at.y - static_cast<float>(ground(at.x, at.z)));
      Vec3 side = glm::dot(at - rest.position[p], fall.axis) < 0 ? -fall.axis : fall.axis, lies = segment;
      float low = 0;
      for (int k = 0; k < kGroundSearches; ++k) {
        Vec3 end = base + lies;
        float deeper = static_cast<float>(ground(end.x, end.z)) + over - end.y;
        if (low + deeper <= 0) break;
        lies = pressed(segment, low += deeper, side);
      }
      if (low > 0) turned[i] = glm::normalize(Quat(segment, lies) * turned[p]);
      pose.position[i] = base + lies;
    }
    pose.turn[i] = turned[i] * pose.turn[i];
  }
}

}  // namespace frond
