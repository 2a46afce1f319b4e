#pragma once

#include <vector>

#include "core/seed.h"
#include "masonry/wall.h"
#include "model/model.h"

namespace frond {

/// A wall of bricks.
struct WallParams {
  WallShape shape;
  std::vector<Color> bricks{{0.50f, 0.29f, 0.22f}, {0.44f, 0.24f, 0.18f}, {0.53f, 0.35f, 0.27f}};
  Color mortar{0.70f, 0.66f, 0.58f};
  Color stone{0.74f, 0.70f, 0.61f};  ///< of sills and lintels
  Color paint{0.80f, 0.83f, 0.79f};  ///< of windows and doors
  double weathering = 0.5;           ///< 0 clean .. 1: soot, damp and moss
};

/// It stands with the middle of its foot at the origin; its hull is closed.
Model build_wall_model(const WallParams& params, Seed seed);

}  // namespace frond
