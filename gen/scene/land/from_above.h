#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "model/surface.h"

// Meshes seen from above, on grids of points.

namespace frond {

inline constexpr float kBare = -1e30f;  ///< height where there is nothing

/// Calls `at(column, row, height)` for each point of a grid under a triangle, points `cell` apart from `low`.
template <class At>
void rasterize(const std::array<Vec3, 3>& t, Vec2 low, float cell, glm::ivec2 size, const At& at) {
  const auto& [p, q, r] = t;
  float area = (q.x - p.x) * (r.z - p.z) - (q.z - p.z) * (r.x - p.x);
  if (std::abs(area) < 1e-12f) return;
  Vec3 least = glm::min(p, glm::min(q, r)), most = glm::max(p, glm::max(q, r));
  auto first = [&](float x, float from) {
    return std::max(0, static_cast<int>(std::ceil((x - from) / cell)));
  };
  auto last = [&](float x, float from, int count) {
    return std::min(count - 1, static_cast<int>(std::floor((x - from) / cell)));
  };
  for (int row = first(least.z, low.y); row <= last(most.z, low.y, size.y); ++row)
    for (int column = first(least.x, low.x); column <= last(most.x, low.x, size.x); ++column) {
      float dx = low.x + static_cast<float>(column) * cell - p.x,
            dz = low.y + static_cast<float>(row) * cell - p.z;
      float s = (dx * (r.z - p.z) - dz * (r.x - p.x)) / area;
      float u = ((q.x - p.x) * dz - (q.z - p.z) * dx) / area;
      if (s < -1e-4f || u < -1e-4f || s + u > 1.0001f) continue;
      at(column, row, p.y + s * (q.y - p.y) + u * (r.y - p.y));
    }
}

inline std::array<Vec3, 3> corners_of(const Surface& surface, const std::array<std::uint32_t, 3>& t) {
  return {surface.position[t[0]], surface.position[t[1]], surface.position[t[2]]};
}

}  // namespace frond
