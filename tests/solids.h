#pragma once

#include <map>
#include <utility>

#include "model/surface.h"

namespace frond {

/// Whether each edge is run through as often one way as the other: no face is missing or turned over.
inline bool closed(const Surface& surface) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (auto [a, b, c] : surface.triangle)
    for (auto [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      edges[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
  for (const auto& [edge, balance] : edges)
    if (balance != 0) return false;
  return !edges.empty();
}

/// A box from corner to corner, without normals.
inline Surface box(Vec3 low, Vec3 high) {
  Surface s;
  for (int i = 0; i < 8; ++i)
    s.position.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  s.triangle = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return s;
}

/// Of a closed surface whose faces look outward.
inline double volume(const Surface& surface) {
  double sum = 0;
  for (auto [a, b, c] : surface.triangle)
    sum += glm::dot(DVec3(surface.position[a]),
                    glm::cross(DVec3(surface.position[b]), DVec3(surface.position[c]))) /
           6;
  return sum;
}

}  // namespace frond
