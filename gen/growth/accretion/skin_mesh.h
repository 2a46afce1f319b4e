#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace frond {

/// A closed triangle mesh that can be stretched and keeps its triangles of about one size. Vertices are never
/// renumbered and know the two vertices that they were inserted between, so that their earlier positions are
/// known.
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
  /// Moves each vertex toward the mean of its neighbours by a share of the offset: `along` the skin, `across`
  /// it.
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
