#pragma once

#include <cmath>

#include "core/vec.h"

namespace frond::cpfg {

/// A vector of length 1, or 0 where it has no direction.
inline DVec3 unit(DVec3 v) {
  double length = std::sqrt(glm::dot(v, v));
  return length > 0 && std::isfinite(length) ? v / length : DVec3{0, 0, 0};
}

/// Turns a vector about an axis of length 1, right-handed.
inline DVec3 turned(DVec3 v, DVec3 axis, double angle) {
  double c = std::cos(angle), s = std::sin(angle);
  return v * c + glm::cross(axis, v) * s + axis * (glm::dot(axis, v) * (1 - c));
}

}  // namespace frond::cpfg
