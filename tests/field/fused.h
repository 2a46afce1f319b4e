#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "model/surface.h"
#include "organisms/coral/coral.h"

namespace frond {

/// What is to be known of a mesh that should be a closed surface.
struct Closure {
  std::size_t open = 0;     // edges that have not as many triangles on one side as on the other
  std::size_t crowded = 0;  // edges of more than two triangles
  long euler = 0;           // vertices in use - edges + triangles
  double volume = 0;        // positive where triangles face outward
};

inline Closure measure(const Surface& s) {
  struct Edge {
    std::uint32_t low, high;
    int sense;
  };
  Closure c;
  std::vector<Edge> edges;
  std::vector<bool> used(s.position.size());
  for (const auto& t : s.triangle) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t a = t[k], b = t[(k + 1) % 3];
      used[a] = true;
      edges.push_back(a < b ? Edge{a, b, 1} : Edge{b, a, -1});
    }
    glm::dvec3 p(s.position[t[0]]), q(s.position[t[1]]), r(s.position[t[2]]);
    c.volume += glm::dot(p, glm::cross(q, r)) / 6;
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t n = i;
    int balance = 0;
    while (n < edges.size() && edges[n].low == edges[i].low && edges[n].high == edges[i].high)
      balance += edges[n++].sense;
    c.open += balance != 0;
    c.crowded += n - i > 2;
    --c.euler;
    i = n;
  }
  c.euler += std::count(used.begin(), used.end(), true) + static_cast<long>(s.triangle.size());
  return c;
}

/// A coral of about 3^steps branches, a metre high.
inline Skeleton test_coral(int steps, double radius = 0.03) {
  CoralParams params;
  params.steps = steps;
  params.height = 1;
  params.thickness.radius = radius;
  return *grow_coral(params, Seed{7});
}

}  // namespace frond
