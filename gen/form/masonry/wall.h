#pragma once

#include <vector>

#include "core/seed.h"
#include "model/surface.h"

namespace frond {

enum class WallHole {
  window,  ///< with frame and panes
  door,    ///< down to the ground, with a leaf of planks
  gap      ///< empty
};

/// An opening in a wall. Metres; snapped to the courses.
struct WallOpening {
  WallHole kind = WallHole::window;
  double at = 0;        ///< of its middle along the wall, from the wall's middle
  double sill = 0.9;    ///< height of its lower edge; ignored for a door
  double width = 1.0;   ///< >= 0.2
  double height = 1.3;  ///< >= 0.2
};

/// A wall of bricks in running bond. Metres.
struct WallShape {
  double width = 4, height = 2.6, thickness = 0.24;
  Vec3 brick{0.24f, 0.065f, 0.115f};  ///< length, height, depth
  double joint = 0.010;               ///< of mortar between them
  double recess = 0.005;              ///< depth of the mortar behind their faces
  double wear = 0.5;                  ///< 0 new .. 1: bricks are tilted and chipped
  double ruin = 0;                    ///< 0 whole .. 0.95: largest share of the height that has fallen down
  bool coping = true;                 ///< a top course of bricks on edge, where the wall is whole
  std::vector<WallOpening> openings;
};

/// The type of a block of a wall.
enum class WallPart { brick, stone, wood, pane };

/// One brick, sill, lintel, bar or pane: a box.
struct WallBlock {
  WallPart part = WallPart::brick;
  Vec3 middle{0}, size{1};
  Quat turn{1, 0, 0, 0};
};

/// A wall along x: the middle of its foot at the origin, its front toward +z.
struct Wall {
  Surface hull;    ///< closed, in the plane of the bricks' faces, with sills and lintels: the host of ivy
  Surface mortar;  ///< closed, `recess` inside the hull
  std::vector<WallBlock> blocks;
};

/// Overlapping openings, and those that reach outside the wall, are clipped.
Wall build_wall(const WallShape& shape, Seed seed);

/// A brick or dressed stone as a box of size 1 about the origin, with edges rounded and chipped as if it had
/// `size` metres; `wear` 0 sharp .. 1 chipped.
Surface worn_block(Vec3 size, double wear, Seed seed);

}  // namespace frond
