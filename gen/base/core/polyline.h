#pragma once

#include <algorithm>
#include <span>

#include "core/vec.h"

// Places along lines through points.

namespace frond {

/// Length of a line through points.
template <class V>
double polyline_length(std::span<const V> points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += glm::distance(points[i - 1], points[i]);
  return length;
}

/// A place on a line, and the direction of the line there.
template <class V>
struct PolylinePoint {
  V at;
  V along{0};  ///< of length 1; 0 where all points are one
};

/// The place so far along a line through one point or more; before its beginning or past its end, that end.
template <class V>
PolylinePoint<V> polyline_point(std::span<const V> points, double far) {
  using Scalar = typename V::value_type;
  PolylinePoint<V> found{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    auto length = static_cast<double>(glm::distance(points[i - 1], points[i]));
    if (length <= 0) continue;
    auto share = static_cast<Scalar>(std::clamp(far / length, 0.0, 1.0));
    found = {glm::mix(points[i - 1], points[i], share),
             (points[i] - points[i - 1]) / static_cast<Scalar>(length)};
    if (far <= length) break;
    far -= length;
  }
  return found;
}

}  // namespace frond
