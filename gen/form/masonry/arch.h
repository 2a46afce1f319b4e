#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace frond {

/// The line of a humped bridge in the plane of x (along) and y (up), metres: two quadratic Bézier curves,
/// mirrored at mid-span, each with the control points (length / 2, 0), (crown * length, height) and (0,
/// height). It is level at mid-span, so its slope is continuous.
struct Arch {
  double length = 10, height = 1.5;
  double crown = 0.25;           ///< 0.1 nearly pointed .. 0.5 vertical at its feet
  std::vector<double> distance;  ///< along the curve, from the foot to t = i / (size - 1) of one half
};

/// A point on the arch with its local axes.
struct ArchPoint {
  glm::dvec2 at{0};
  glm::dvec2 along{1, 0};  ///< of length 1, toward +x
  glm::dvec2 up{0, 1};     ///< of length 1, across the arch
};

/// Measures the arch. `length` > 0, `height` >= 0.
Arch make_arch(double length, double height, double crown);

/// Length of one half along the curve.
double half_length(const Arch& arch);

/// The point `s` metres along the arch from mid-span, toward +x if positive. Straight beyond its feet.
ArchPoint arch_at(const Arch& arch, double s);

/// Height at x, which is clamped to -length / 2 .. length / 2.
double arch_height(const Arch& arch, double x);

/// The smallest radius of curvature: an offset curve below the arch at less than this distance does not cross
/// itself.
double least_radius(const Arch& arch);

}  // namespace frond
