#pragma once

#include <algorithm>
#include <cmath>

#include "core/vec.h"

// Areas of triangles, and places all over them.

namespace frond {

template <class V>
typename V::value_type triangle_area(const V& a, const V& b, const V& c) {
  return glm::length(glm::cross(b - a, c - a)) / 2;
}

/// Weights of the corners for a place in a triangle, each as likely as any other, by two numbers of 0..1.
inline DVec3 drawn_weights(double u, double v) {
  double root = std::sqrt(u);
  return {1 - root, root * (1 - v), root * v};
}

/// Calls `visit(place)` for places all over a triangle, rims and corners, at most `step` from each other.
template <class Visit>
void over_triangle(Vec3 a, Vec3 b, Vec3 c, float step, const Visit& visit) {
  float longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
  int n = std::max(1, static_cast<int>(std::ceil(longest / step)));
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j)
      visit(a + (b - a) * (static_cast<float>(i) / static_cast<float>(n)) +
            (c - a) * (static_cast<float>(j) / static_cast<float>(n)));
}

}  // namespace frond
