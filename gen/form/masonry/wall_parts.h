#pragma once

#include <vector>

#include "masonry/wall.h"

// Parts of a wall; see wall.h.

namespace frond {

/// The face of a wall as cells between lines, each solid or open. Row by row from the bottom.
struct FaceGrid {
  std::vector<double> x, y;  ///< increasing
  std::vector<bool> solid;   ///< (x.size() - 1) * (y.size() - 1)

  /// Whether the point is in a solid cell.
  bool at(double along, double height) const;
  bool cell(std::ptrdiff_t column, std::ptrdiff_t row) const;
};

/// The solid cells as a closed body from z = -half to half, its outline moved in by `inset`. Faces that meet
/// share vertices.
Surface extruded(const FaceGrid& grid, double half, double inset);

/// Appends a closed box.
void append_box(Surface& to, Vec3 middle, Vec3 size);

/// An opening filled with frame and panes, or with planks. Metres.
struct Joinery {
  double left, right, low, high, thickness;
  bool door;
};

/// Appends frame, bars and panes of a window, or frame and planks of a door.
void append_joinery(std::vector<WallBlock>& blocks, const Joinery& hole);

}  // namespace frond
