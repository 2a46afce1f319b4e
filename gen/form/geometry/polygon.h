#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/vec.h"

namespace frond {

/// The area vector of a polygon: its length is the area, its direction the side from which it runs
/// counter-clockwise (Newell's method). One that is not flat counts by its projection on its mean plane.
template <class Points>
auto polygon_area(const Points& points) {
  using V = std::remove_cvref_t<decltype(points[0])>;
  V sum(0);
  for (std::size_t i = 0; i < points.size(); ++i)
    sum += glm::cross(points[i] - points[0], points[(i + 1) % points.size()] - points[0]);
  return sum * typename V::value_type(0.5);
}

/// Two axes in the mean plane of a polygon, of length 1, from one to the other as it runs.
template <class Points>
auto plane_axes(const Points& points) {
  auto normal = polygon_area(points);
  auto length = glm::length(normal);
  normal = length > 0 ? normal / length : decltype(normal)(0, 0, 1);
  auto x = glm::normalize(glm::cross(reference_axis(normal), normal));
  return std::pair(x, glm::cross(normal, x));
}

/// A polygon of three corners or more as triangles that together cover just what it encloses, in its
/// orientation: concave ones, those in any plane, and those whose outline touches itself, such as one with a
/// hole that is reached through a slit. Of the ways to cut it, the one with the shortest cuts. What is not
/// flat is cut as it looks along its area; of an outline that crosses itself as little is turned over as can
/// be. False where more than 2000 corners are so entangled that no ear can be cut off.
[[nodiscard]] bool triangulate_polygon(std::span<const DVec3> points,
                                       std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace frond
