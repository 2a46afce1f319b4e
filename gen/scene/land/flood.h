#pragma once

#include <vector>

#include "core/vec.h"

namespace frond {

/// A square piece of ground as heights at points of a grid, row by row; metres.
struct GroundGrid {
  Vec2 low{0};  ///< x, z of the first point
  float cell = 0.08f;
  int side = 0;  ///< points
  std::vector<float> height;
  std::vector<bool> drain;  ///< where water runs off, as into a pond; its rim is one, too

  std::size_t index(int column, int row) const { return static_cast<std::size_t>(row * side + column); }
  Vec2 place(std::size_t point) const {
    return low + cell * Vec2(static_cast<int>(point) % side, static_cast<int>(point) / side);
  }
};

/// Calls `each(point)` for the points beside one, up to eight.
template <class Each>
void each_beside(const GroundGrid& ground, std::size_t point, const Each& each) {
  constexpr int kSteps[8][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}};
  int column = static_cast<int>(point) % ground.side, row = static_cast<int>(point) / ground.side;
  for (const auto& [x, y] : kSteps) {
    int c = column + x, r = row + y;
    if (c >= 0 && r >= 0 && c < ground.side && r < ground.side) each(ground.index(c, r));
  }
}

/// How water runs off a piece of ground.
struct Flood {
  std::vector<float> level;       ///< metres, as if every hollow were filled to its brim
  std::vector<std::size_t> next;  ///< the point that each drains to, out of hollows over their lowest saddle;
                                  ///< a drain to itself
};

/// By a priority flood from the drains inward, always the lowest first (Barnes, Lehman and Mulla 2014).
Flood priority_flood(const GroundGrid& ground);

}  // namespace frond
