#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "model/surface.h"

namespace frond {

inline bool meets_triangle(Vec3 from, Vec3 to, Vec3 a, Vec3 b, Vec3 c) {
  DVec3 p(from), way = DVec3(to) - p, e1 = DVec3(b) - DVec3(a), e2 = DVec3(c) - DVec3(a),
                 h = glm::cross(way, e2);
  double det = glm::dot(e1, h);
  if (std::abs(det) < 1e-18) return false;
  DVec3 s = p - DVec3(a), k = glm::cross(s, e1);
  double u = glm::dot(s, h) / det, v = glm::dot(way, k) / det, t = glm::dot(e2, k) / det;
  return u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t <= 1;
}

/// Pairs of triangles without a common corner that go through each other, by a grid of such cells.
inline std::size_t crossings_of(const Surface& s, float cell) {
  std::map<std::array<int, 3>, std::vector<std::uint32_t>> grid;
  std::set<std::pair<std::uint32_t, std::uint32_t>> found;
  auto through = [&](std::uint32_t one, std::uint32_t other) {
    const auto &t = s.triangle[one], &o = s.triangle[other];
    for (int e = 0; e < 3; ++e)
      if (meets_triangle(s.position[t[static_cast<std::size_t>(e)]],
                         s.position[t[static_cast<std::size_t>((e + 1) % 3)]], s.position[o[0]],
                         s.position[o[1]], s.position[o[2]]))
        return true;
    return false;
  };
  for (std::uint32_t t = 0; t < s.triangle.size(); ++t) {
    Vec3 low(1e9f), high(-1e9f);
    for (std::uint32_t v : s.triangle[t])
      low = glm::min(low, s.position[v]), high = glm::max(high, s.position[v]);
    auto first = [&](int axis) { return static_cast<int>(std::floor(low[axis] / cell)); };
    auto last = [&](int axis) { return static_cast<int>(std::floor(high[axis] / cell)); };
    for (int x = first(0); x <= last(0); ++x)
      for (int y = first(1); y <= last(1); ++y)
        for (int z = first(2); z <= last(2); ++z) {
          auto& list = grid[{x, y, z}];
          for (std::uint32_t o : list) {
            bool share = false;
            for (std::uint32_t v : s.triangle[t]) share = share || std::ranges::count(s.triangle[o], v) > 0;
            if (!share && (through(t, o) || through(o, t))) found.insert({o, t});
          }
          list.push_back(t);
        }
  }
  return found.size();
}

}  // namespace frond
