#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "core/vec.h"

// Smooth lines through points, as drawing programs have them.

namespace frond {

/// The handle on one side of a point, which is opposite to that on the other side where only that is given.
template <class V>
V handle_of(const std::optional<V>& own, const std::optional<V>& other) {
  return own ? *own : other ? -*other : V{};
}

/// A place on the cubic Bézier curve of four control points, `t` of 0..1 along it.
template <class V, class Scalar>
V cubic_place(const V& a, const V& b, const V& c, const V& d, Scalar t) {
  Scalar s = 1 - t;
  return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
}

/// The slopes of a smooth line at a point, of the way that comes to it and of the one that goes on, each for
/// the whole of its way.
template <class V>
struct SplineSlopes {
  V in, out;
};

/// Where both ways are about as long, the slope of Catmull and Rom (1974): half the way from the point before
/// to the one after. Where one is much longer, this would carry the line past the point and back; there the
/// slopes are those of their centripetal curve, which go with the length of each way (Yuksel, Schaefer and
/// Keyser 2011), and in between they pass from the one to the other.
template <class V>
SplineSlopes<V> spline_slopes(const V& before, const V& at, const V& after) {
  using Scalar = typename V::value_type;
  const V come = at - before, go = after - at, even = (after - before) * Scalar(0.5);
  const Scalar a = glm::length(come), b = glm::length(go), ratio = std::max(a, b) / std::min(a, b);
  if (!(ratio > Scalar(1.5))) return {even, even};
  if (!(std::min(a, b) > 0)) return {V(0), V(0)};
  const Scalar s = std::min((ratio - Scalar(1.5)) / Scalar(1.5), Scalar(1)), share = s * s * (3 - 2 * s);
  const Scalar in = std::sqrt(a), out = std::sqrt(b);
  const V speed = (come * (out / in) + go * (in / out)) / (in + out);
  // Both of one direction, or there would be a corner.
  const V way = even + (speed * std::sqrt(in * out) - even) * share;
  const Scalar long_even = glm::length(even), long_speed = glm::length(speed), unit = glm::length(way);
  if (!(unit > 0)) return {V(0), V(0)};
  const auto slope = [&](Scalar along) {
    return way * ((long_even + (long_speed * along - long_even) * share) / unit);
  };
  return {slope(in), slope(out)};
}

/// A point of a line. Its handles lead from it to the control points of the cubic Bézier curves that end and
/// begin there; where only one is given the other is opposite to it, and without any the line has a corner
/// there or, where it is smooth, the slope that spline_slopes() gives.
template <class V>
struct SplinePoint {
  V at{0};
  std::optional<V> in = {}, out = {};

  SplinePoint() = default;
  SplinePoint(V place) : at(place) {}
  SplinePoint(V place, std::optional<V> back, std::optional<V> on) : at(place), in(back), out(on) {}

  bool handled() const { return in || out; }
};

struct SplineShape {
  bool smooth = false;  ///< also where points have no handles
  bool closed = false;  ///< whether it goes on from the last point to the first, which is not repeated
  int pieces = 12;      ///< from point to point, > 0; one where it is straight
};

/// Places along the line through points; the points themselves are among them.
template <class V>
std::vector<V> spline_places(std::span<const SplinePoint<V>> points, const SplineShape& shape) {
  using Scalar = typename V::value_type;
  std::size_t count = points.size(), spans = shape.closed || count == 0 ? count : count - 1;
  auto near = [&](std::size_t i, int aside) {  // within the line, or round it
    auto k = static_cast<std::ptrdiff_t>(i) + aside, n = static_cast<std::ptrdiff_t>(count);
    return points[shape.closed ? (k + n) % n : std::clamp<std::ptrdiff_t>(k, 0, n - 1)].at;
  };
  auto handle = [&](std::size_t i, bool on) -> V {
    const SplinePoint<V>& p = points[i];
    if (p.handled()) return on ? handle_of(p.out, p.in) : handle_of(p.in, p.out);
    if (!shape.smooth) return V(0);
    bool inner = shape.closed || (i > 0 && i + 1 < count);
    if (!inner) return (near(i, 1) - near(i, -1)) * static_cast<Scalar>(on ? 1.0 / 6 : -1.0 / 6);
    SplineSlopes<V> slopes = spline_slopes(near(i, -1), p.at, near(i, 1));
    return (on ? slopes.out : slopes.in) * static_cast<Scalar>(on ? 1.0 / 3 : -1.0 / 3);
  };
  std::vector<V> places;
  for (std::size_t i = 0; i < spans; ++i) {
    std::size_t j = (i + 1) % count;
    V a = points[i].at, d = points[j].at;
    places.push_back(a);
    if (!shape.smooth && !points[i].handled() && !points[j].handled()) continue;
    V b = a + handle(i, true), c = d + handle(j, false);
    for (int k = 1; k < shape.pieces; ++k) {
      Scalar t = static_cast<Scalar>(k) / static_cast<Scalar>(shape.pieces);
      places.push_back(cubic_place(a, b, c, d, t));
    }
  }
  if (count > 0 && !shape.closed) places.push_back(points.back().at);
  return places;
}

/// Only the points of a line.
template <class V>
std::vector<V> spline_points(const std::vector<SplinePoint<V>>& line) {
  std::vector<V> points;
  for (const SplinePoint<V>& point : line) points.push_back(point.at);
  return points;
}

}  // namespace frond
