#pragma once

#include <cmath>

#include "core/vec.h"

namespace frond {

/// Axes at a place of a stalk: along it, and two across.
struct StalkFrame {
  Vec3 along{0, 1, 0}, front{0, 0, 1}, side{1, 0, 0};

  /// The direction at an angle to the stalk and an azimuth about it.
  Vec3 direction(double angle, double azimuth) const {
    auto s = static_cast<float>(std::sin(angle)), c = static_cast<float>(std::cos(angle));
    Vec3 out = side * static_cast<float>(std::sin(azimuth)) + front * static_cast<float>(std::cos(azimuth));
    return along * c + out * s;
  }
};

/// The axes along a direction of length 1, the front one nearest to `near`.
inline StalkFrame frame_along(Vec3 along, Vec3 near) {
  StalkFrame f{along,
               direction_or(near - along * glm::dot(near, along),
                            glm::normalize(glm::cross(along, reference_axis(along)))),
               {}};
  f.side = glm::cross(f.along, f.front);
  return f;
}

}  // namespace frond
