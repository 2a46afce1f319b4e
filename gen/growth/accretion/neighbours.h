#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace frond {

/// For each vertex of a closed mesh, the mean of `own` over its neighbours; its own value where it has none.
template <class T>
std::vector<T> means_of_neighbours(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                   const std::vector<T>& own) {
  // Each neighbour comes twice, from the triangles to both sides of the edge to it.
  std::vector<T> mean(own.size(), T(0));
  std::vector<float> count(own.size(), 0);
  for (auto [a, b, c] : triangles) {
    mean[a] += own[b] + own[c], mean[b] += own[c] + own[a], mean[c] += own[a] + own[b];
    count[a] += 2, count[b] += 2, count[c] += 2;
  }
  for (std::size_t v = 0; v < own.size(); ++v) mean[v] = count[v] > 0 ? mean[v] / count[v] : own[v];
  return mean;
}

}  // namespace frond
