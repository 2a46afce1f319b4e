#include "export/weld.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

namespace frond {

namespace {

constexpr double kOfVoxel = 0.01, kMostOfVoxel = 0.1;
constexpr double kFiveDigits = 3e-5;  // metres: apart in files of five decimals

using Corners = std::array<std::uint32_t, 3>;

Corners sorted(Corners t) {
  std::ranges::sort(t);
  return t;
}

/// Takes away faces that name a vertex twice, and such as lie back to back.
void drop_flat(std::vector<Corners>& triangles) {
  std::erase_if(triangles, [](const Corners& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  std::map<Corners, int> times;
  for (const Corners& t : triangles) ++times[sorted(t)];
  std::erase_if(triangles, [&](const Corners& t) { return times[sorted(t)] % 2 == 0; });
}

}  // namespace

double shortest_edge(double voxel) {
  return std::min(std::max(kOfVoxel * voxel, kFiveDigits), kMostOfVoxel * voxel);
}

void join_short_edges(Surface& s, std::vector<std::int32_t>& node, double least) {
  std::vector<std::uint32_t> stands(s.position.size());
  std::iota(stands.begin(), stands.end(), 0u);
  auto find = [&](std::uint32_t v) {
    while (stands[v] != v) v = stands[v] = stands[stands[v]];
    return v;
  };
  bool any = false;
  for (const Corners& t : s.triangle)
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (glm::distance(s.position[a], s.position[b]) >= static_cast<float>(least)) continue;
      a = find(a), b = find(b);
      stands[std::max(a, b)] = std::min(a, b);
      any = true;
    }
  if (!any) return;
  for (Corners& t : s.triangle)
    for (std::uint32_t& v : t) v = find(v);
  drop_flat(s.triangle);
  std::vector<std::uint32_t> index(s.position.size(), UINT32_MAX);
  for (const Corners& t : s.triangle)
    for (std::uint32_t v : t) index[v] = 0;
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < index.size(); ++v) {
    if (index[v] != 0) continue;
    s.position[kept] = s.position[v], s.normal[kept] = s.normal[v], node[kept] = node[v];
    index[v] = kept++;
  }
  s.position.resize(kept), s.normal.resize(kept), node.resize(kept);
  for (Corners& t : s.triangle)
    for (std::uint32_t& v : t) v = index[v];
}

}  // namespace frond
