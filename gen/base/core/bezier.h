#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace frond {

/// A point on a Bézier curve: position, first and second derivative.
struct BezierJet {
  glm::dvec2 at{0}, slope{0}, bend{0};
};

/// The curve of the given control points at `t` in 0..1 by repeated midpoints (de Casteljau 1959), which is
/// as stable at degree 20 as at degree 1. The degree is one less than the number of points, at least one.
BezierJet bezier_jet(std::span<const glm::dvec2> control, double t);

/// Control points, one more than `control`, of the same curve (Forrest 1972).
std::vector<glm::dvec2> bezier_raised(std::span<const glm::dvec2> control);

}  // namespace frond
