#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/surface.h"

namespace frond {

/// A set of triangles put in order: equal positions are one vertex, neighbours agree on the outer side, and
/// triangles without area are gone. See TriangleSurface.
struct Soup {
  std::vector<std::array<Vec3, 3>> corners;
  std::vector<std::array<std::uint32_t, 3>> vertex;
  std::vector<std::array<std::uint32_t, 3>> neighbour;  ///< across the edges 01, 12 and 20, or ~0u
  std::vector<std::uint8_t> solid;                      ///< part of a closed piece
  std::vector<std::uint32_t> piece;                     ///< connected triangles have the same number
  std::vector<std::array<Vec3, 3>> paint;               ///< as that of the surface; may be empty
  std::size_t vertices = 0, pieces = 0;
};

Soup mend_surface(const Surface& surface);

/// Reverses the orientation of one triangle.
void flip(Soup& soup, std::uint32_t triangle);

}  // namespace frond
