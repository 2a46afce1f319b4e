#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "model/surface.h"

namespace frond {

/// What a printer wants to know of a mesh. Vertices at one place count as one.
struct PrintedPieces {
  std::size_t crowded = 0;  ///< edges that are not of exactly two triangles, one each way
  std::size_t flat = 0;     ///< triangles that have a corner twice
  std::vector<double>
      volume;  ///< m3, of each piece that hangs together by edges; below 0 for the wall of a void
};

inline PrintedPieces printed_pieces(const Surface& s) {
  std::map<std::array<float, 3>, std::size_t> places;
  auto weld = [&](std::uint32_t v) {
    const Vec3& p = s.position[v];
    return places.try_emplace({p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}, places.size()).first->second;
  };
  struct Run {
    std::size_t low, high, triangle;
    bool up;
  };
  PrintedPieces result;
  std::vector<Run> runs;
  for (std::size_t t = 0; t < s.triangle.size(); ++t) {
    auto [a, b, c] = s.triangle[t];
    std::array<std::size_t, 3> v{weld(a), weld(b), weld(c)};
    result.flat += v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
    for (std::size_t k = 0; k < 3; ++k) {
      std::size_t from = v[k], to = v[(k + 1) % 3];
      runs.push_back({std::min(from, to), std::max(from, to), t, from < to});
    }
  }
  std::sort(runs.begin(), runs.end(),
            [](const Run& a, const Run& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
  std::vector<std::size_t> up(s.triangle.size());
  for (std::size_t t = 0; t < up.size(); ++t) up[t] = t;
  auto top = [&](std::size_t t) {
    while (up[t] != t) t = up[t] = up[up[t]];
    return t;
  };
  for (std::size_t i = 0; i < runs.size();) {
    std::size_t n = i;
    int balance = 0;
    for (; n < runs.size() && runs[n].low == runs[i].low && runs[n].high == runs[i].high; ++n) {
      balance += runs[n].up ? 1 : -1;
      up[top(runs[n].triangle)] = top(runs[i].triangle);
    }
    result.crowded += n - i != 2 || balance != 0;
    i = n;
  }
  std::map<std::size_t, double> volume;
  for (std::size_t t = 0; t < s.triangle.size(); ++t) {
    auto [a, b, c] = s.triangle[t];
    glm::dvec3 p(s.position[a]), q(s.position[b]), r(s.position[c]);
    volume[top(t)] += glm::dot(p, glm::cross(q, r)) / 6;
  }
  for (auto [piece, size] : volume) result.volume.push_back(size);
  return result;
}

}  // namespace frond
