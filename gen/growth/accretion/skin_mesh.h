#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/vec.h"

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

/// A closed triangle mesh that can be stretched and keeps its triangles of about one size. Vertices are never
/// renumbered and know the two vertices that they were inserted between, so where they were earlier.
class SkinMesh {
 public:
  using Triangle = std::array<std::uint32_t, 3>;
  static constexpr std::uint32_t kNone = ~0u;

  std::vector<Vec3> position;
  std::vector<Vec3> normal;                           // of the living vertices; see set_normals()
  std::vector<std::array<std::uint32_t, 2>> parents;  // kNone for the initial vertices
  std::vector<Triangle> triangle;

  /// A ball with a radius in metres about a middle; edges about `edge` long.
  void start(Vec3 middle, float radius, float edge);

  void set_normals();
  /// Splits edges longer than 4/3 of `edge`; with `whole` also collapses those shorter than 1/2 of it and
  /// flips edges that improve the triangles.
  void remesh(float edge, bool whole);
  /// Moves each vertex toward the mean of its neighbours by a share: `along` the skin, `across` it.
  void relax(float along, float across);

  /// The remaining vertices in order of their numbers, and the index of each in that order.
  std::vector<std::uint32_t> living(std::vector<std::uint32_t>& order) const;

 private:
  void split(float longest);
  void flip();
  void collapse(float shortest);
  /// Whether a triangle at `from` turns over where that vertex goes to `to`.
  bool folds(const Triangle& t, std::uint32_t from, std::uint32_t to) const;
};

}  // namespace frond
