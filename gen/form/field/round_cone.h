#pragma once

#include <algorithm>
#include <cmath>

#include "core/vec.h"

namespace frond {

/// A segment of a branch: the hull of two spheres, with its distance function. Metres.
struct RoundCone {
  Vec3 from{0};
  Vec3 axis{0, 1, 0};  ///< of length 1, toward the other end
  float length = 0;    ///< between the middles of the two spheres
  float radius = 0;    ///< of the sphere at `from`
  float taper = 0;     ///< decrease of the radius per metre of the axis; within -0.98..0.98
  float lean = 0;  ///< shift along the axis of the nearest axis point, per metre of distance from the axis
  std::int32_t node = 0;  ///< of the skeleton, at its end
  std::int32_t root = 0;  ///< root node of its skeleton: cones of one root are connected

  float end_radius() const { return radius - taper * length; }
  Vec3 to() const { return from + axis * length; }
};

/// The hull of two spheres. Where one contains the other it is that one alone.
inline RoundCone make_cone(Vec3 from, float from_radius, Vec3 to, float to_radius, std::int32_t node) {
  RoundCone cone{from, Vec3(0, 1, 0), 0, from_radius, 0, 0, node, 0};
  Vec3 offset = to - from;
  float length = glm::length(offset), drop = from_radius - to_radius;
  if (std::abs(drop) >= 0.98f * length) {
    if (drop < 0) cone.from = to, cone.radius = to_radius;
    return cone;
  }
  cone.axis = offset / length;
  cone.length = length;
  cone.taper = drop / length;
  cone.lean = cone.taper / std::sqrt(1 - cone.taper * cone.taper);
  return cone;
}

/// Position along the axis of the point that belongs to the nearest surface point.
inline float foot_along(const RoundCone& cone, Vec3 away) {
  float along = glm::dot(away, cone.axis);
  float across = std::sqrt(std::max(glm::dot(away, away) - along * along, 0.0f));
  return std::clamp(along - across * cone.lean, 0.0f, cone.length);
}

/// The distance from the surface, negative inside; exact.
inline float distance(const RoundCone& cone, Vec3 at) {
  Vec3 away = at - cone.from;
  float foot = foot_along(cone, away);
  return glm::length(away - cone.axis * foot) - (cone.radius - cone.taper * foot);
}

/// The gradient of that distance; of length 1.
inline Vec3 outward(const RoundCone& cone, Vec3 at) {
  Vec3 away = at - cone.from;
  away -= cone.axis * foot_along(cone, away);
  float length = glm::length(away);
  return length > 0 ? away / length : Vec3(0, 1, 0);
}

}  // namespace frond
