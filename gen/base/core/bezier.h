#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace frond {

/// A point on a Bézier curve: position, first and second derivative.
template <class V>
struct BezierJet {
  V at{0}, slope{0}, bend{0};
};

/// The curve of the given control points at `t` in 0..1 by repeated midpoints (de Casteljau 1959), which is
/// as stable at degree 20 as at degree 1. The degree is one less than the number of points, at least one. `V`
/// is glm::dvec2 or glm::dvec3.
template <class V>
BezierJet<V> bezier_jet(std::span<const V> control, double t);

/// Control points, one more than `control`, of the same curve (Forrest 1972).
template <class V>
std::vector<V> bezier_raised(std::span<const V> control);

extern template BezierJet<glm::dvec2> bezier_jet(std::span<const glm::dvec2>, double);
extern template BezierJet<glm::dvec3> bezier_jet(std::span<const glm::dvec3>, double);
extern template std::vector<glm::dvec2> bezier_raised(std::span<const glm::dvec2>);
extern template std::vector<glm::dvec3> bezier_raised(std::span<const glm::dvec3>);

}  // namespace frond
