#pragma once

#include <map>
#include <utility>

#include "model/surface.h"

namespace frond {

/// What a triangle mesh is as a body.
struct Body {
  std::size_t loose =
      0;              ///< edges that are not run exactly once in each direction; 0: closed and turned one way
  long euler = 0;     ///< vertices that are used - edges + triangles; 2 for each ball
  double volume = 0;  ///< as volume_of
};

/// Above 0 where the triangles of a closed mesh are turned outward; m3.
inline double volume_of(const Surface& s) {
  double volume = 0;
  for (auto [a, b, c] : s.triangle) {
    glm::dvec3 p(s.position[a]), q(s.position[b]), r(s.position[c]);
    volume += glm::dot(p, glm::cross(q, r)) / 6;
  }
  return volume;
}

inline Body body_of(const Surface& s) {
  Body body;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  std::map<std::uint32_t, int> used;
  for (auto [a, b, c] : s.triangle) {
    ++edges[{a, b}], ++edges[{b, c}], ++edges[{c, a}];
    ++used[a], ++used[b], ++used[c];
  }
  body.volume = volume_of(s);
  for (auto& [edge, count] : edges)
    if (count != 1 || !edges.contains({edge.second, edge.first})) ++body.loose;
  body.euler = static_cast<long>(used.size() + s.triangle.size()) - static_cast<long>(edges.size() / 2);
  return body;
}

}  // namespace frond
