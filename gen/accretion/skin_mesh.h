#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace frond {

/// A closed triangle mesh that is stretched, and keeps its triangles of one size. Vertices are never
/// renumbered and know the two that they came up between, so that where one was before it was there is known,
/// too.
class SkinMesh {
 public:
  using Triangle = std::array<std::uint32_t, 3>;
  static constexpr std::uint32_t kNone = ~0u;

  std::vector<Vec3> position;
  std::vector<Vec3> normal;                           // of the living; see set_normals()
  std::vector<std::array<std::uint32_t, 2>> parents;  // kNone for the first ones
  std::vector<Triangle> triangle;

  /// A ball of so many metres about a middle; triangles about `edge` long.
  void start(Vec3 middle, float radius, float edge);

  void set_normals();
  /// Makes edges shorter than 4/3 of `edge` and, where the `whole` is wanted, longer than 1/2 of it, and
  /// turns those that cross a better one.
  void remesh(float edge, bool whole);
  /// Moves each vertex by a share of the way to the middle of its neighbours, along the skin and across it.
  void relax(float along, float across);

  /// Vertices that are left, in the order of their numbers, and the number in that order of each.
  std::vector<std::uint32_t> living(std::vector<std::uint32_t>& order) const;

 private:
  void split(float longest);
  void flip();
  void collapse(float shortest);
};

}  // namespace frond
