#pragma once

#include <vector>

#include "masonry/wall.h"

// What a wall is put together from; see wall.h.

namespace frond {

/// The face of a wall as cells between lines: which of them are solid. Row by row from the bottom.
struct FaceGrid {
  std::vector<double> x, y;  ///< increasing
  std::vector<bool> solid;   ///< (x.size() - 1) * (y.size() - 1)

  /// Whether the place lies in a solid cell.
  bool at(double along, double height) const;
  bool cell(std::ptrdiff_t column, std::ptrdiff_t row) const;
};

/// The solid cells as a closed body from z = -half to half, its outline drawn in by `inset`. Vertices are
/// shared by the faces that meet there.
Surface extruded(const FaceGrid& grid, double half, double inset);

/// Appends a closed box.
void append_box(Surface& to, Vec3 middle, Vec3 size);

/// A hole that is filled with frame and panes, or with planks. Metres.
struct Joinery {
  double left, right, low, high, thickness;
  bool door;
};

/// Appends frame, bars and panes of a window, or frame and planks of a door.
void append_joinery(std::vector<WallBlock>& blocks, const Joinery& hole);

}  // namespace frond
