#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rocks/blobs.h"

namespace frond {

/// How finely an implicit surface is cut into cells.
struct CellOptions {
  int depth = 7;  ///< 1..10: the finest cells are 1/2^depth of the whole, where all is clear
  double tolerance =
      0.0003;  ///< share of the size of the surface that flat places may be off; 0: finest cells all over
};

/// The leaves of an octree round an implicit surface. Cells that interval arithmetic shows to be free of it
/// stay large; neighbours, also over edges, differ by at most one level.
///
/// Cells are cut finer than `depth` where it is not yet certain that nothing is hidden in them: where f might
/// turn back along its own gradient within twice the width of the cell. Where it cannot, the surface there is
/// a graph over a plane, and no part of it lies unseen between the middles of cells (after Plantinga and
/// Vegter 2004). Where f touches 0 without crossing it this never ends, and is given up at kDeepest.
struct BlobCells {
  struct Cell {
    std::int32_t child = -1;            ///< the first of eight, or -1: a leaf
    std::array<std::uint16_t, 3> at{};  ///< its lower corner, in cells of its level
    std::uint8_t level = 0;
    bool inside = false;  ///< whether f > 0 in its middle
    bool clear = false;   ///< certainly free of the surface
  };
  static constexpr int kDeepest = 12;

  Box root;                ///< a cube; the surface ends well within
  double size = 0;         ///< of the surface: the longest side of its box
  std::vector<Cell> cell;  ///< the first is the root; empty where there is no surface

  Box box(const Cell& c) const;
};

BlobCells cut_cells(const Blobs& shape, const CellOptions& options);

}  // namespace frond
