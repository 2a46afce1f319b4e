#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rocks/blobs.h"

namespace frond {

/// Resolution of the cells of an implicit surface.
struct CellOptions {
  int depth = 7;  ///< 1..10: the finest cells are 1/2^depth of the whole, unless refined for certainty
  double tolerance =
      0.0003;  ///< allowed error of flat places, as a share of the surface's size; 0: finest cells everywhere
};

/// The leaves of an octree round an implicit surface. Cells that are free of it by interval arithmetic stay
/// large; neighbours, including those across edges, differ by at most one level.
///
/// Cells are refined beyond `depth` while parts of the surface might be missed: where f might reverse along
/// its own gradient within twice the width of the cell. Otherwise the surface there is a graph over a plane,
/// and no part of it is missed between the middles of cells (after Plantinga and Vegter 2004). Where f
/// touches 0 without crossing it, refinement would never end; it stops at kDeepest.
struct BlobCells {
  struct Cell {
    std::int32_t child = -1;            ///< index of the first of eight, or -1: a leaf
    std::array<std::uint16_t, 3> at{};  ///< its lower corner, in cells of its level
    std::uint8_t level = 0;
    bool inside = false;  ///< whether f > 0 at its middle
    bool clear = false;   ///< certainly free of the surface
  };
  static constexpr int kDeepest = 12;

  Box root;                ///< a cube that contains the surface with a margin
  double size = 0;         ///< of the surface: the longest side of its box
  std::vector<Cell> cell;  ///< the first is the root; empty where there is no surface

  Box box(const Cell& c) const;
};

BlobCells cut_cells(const Blobs& shape, const CellOptions& options);

}  // namespace frond
