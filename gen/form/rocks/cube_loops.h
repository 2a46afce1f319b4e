#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace frond {

/// Marching cubes (Lorensen and Cline 1987) with loops instead of triangles. Corner i of a cube is at x = i &
/// 1, y = i >> 1 & 1, z = i >> 2. On a face with four crossings, the corners inside are cut off separately;
/// both cubes of the face do so, so the surface has no holes.
struct CubeLoops {
  static constexpr int kEdges = 12;
  /// The two corners of each edge, the lower one first.
  static const std::array<std::array<std::uint8_t, 2>, kEdges>& edges();

  struct Step {
    std::uint8_t edge;  ///< crossed by the surface
    std::uint8_t face;  ///< through which the loop continues to the next step
  };
  using Loop = std::vector<Step>;

  /// The loops in which the surface crosses the cube's edges, one entry per set of corners inside (bit i for
  /// corner i); counter-clockwise seen from outside.
  static const std::array<std::vector<Loop>, 256>& table();
};

}  // namespace frond
