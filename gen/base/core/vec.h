#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace frond {

/// Right-handed, y up; metres. Models are stored in single precision; a turtle walks in double precision.
using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using DVec3 = glm::dvec3;
using Quat = glm::quat;

/// An sRGB colour, each channel 0 to 1.
struct Color {
  float red = 1, green = 1, blue = 1;
  bool operator==(const Color&) const = default;
};

inline Color mixed(const Color& from, const Color& to, float share) {
  auto mix = [&](float a, float b) { return a + (b - a) * share; };
  return {mix(from.red, to.red), mix(from.green, to.green), mix(from.blue, to.blue)};
}

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kGravity = 9.81;  ///< m/s2

/// The golden angle in radians, for even spirals: 2 pi (2 - golden ratio).
inline constexpr double kGoldenAngle = 2.39996322972865332;

template <class T>
constexpr T radians(T degrees) {
  return degrees * static_cast<T>(kPi / 180.0);
}

template <class T>
constexpr T degrees(T radians) {
  return radians * static_cast<T>(180.0 / kPi);
}

/// The direction of a vector, of length 1; `otherwise` where its length is at most `least` or not a number.
inline Vec3 direction_or(Vec3 v, Vec3 otherwise, float least = 1e-9f) {
  return glm::length(v) > least ? glm::normalize(v) : otherwise;
}

/// A coordinate axis that is not parallel to a direction of length 1: y, or x within 26 degrees of y.
template <class V>
V reference_axis(V direction) {
  using T = typename V::value_type;
  return std::abs(direction.y) < T(0.9) ? V(0, 1, 0) : V(1, 0, 0);
}

/// The direction that is upward in a picture seen along a direction of length 1: y, or -z where it looks
/// straight up or down.
template <class V>
V sky_axis(V direction) {
  using T = typename V::value_type;
  return std::abs(direction.y) > T(0.999) ? V(0, 0, -1) : V(0, 1, 0);
}

/// The axes of what is scaled along its own and then turned.
inline glm::mat3 axes_of(Quat turn, Vec3 scale) {
  glm::mat3 axes = glm::mat3_cast(turn);
  for (int axis = 0; axis < 3; ++axis) axes[axis] *= scale[axis];
  return axes;
}

/// Direction k of `count` in the upper half of all directions, spread so that under a uniform sky each gives
/// a level surface the same amount of light.
inline Vec3 sky_direction(int k, int count) {
  float up = std::sqrt((static_cast<float>(k) + 0.5f) / static_cast<float>(count)),
        flat = std::sqrt(1 - up * up);
  float turn = static_cast<float>(kGoldenAngle) * static_cast<float>(k);
  return {flat * std::cos(turn), up, flat * std::sin(turn)};
}

/// 0 below `low`, 1 above `high`, smooth in value and slope between them.
template <class T>
constexpr T smooth_step(T low, T high, T x) {
  if (x <= low) return 0;
  if (x >= high) return 1;
  T t = (x - low) / (high - low);
  return t * t * (3 - 2 * t);
}

}  // namespace frond
