#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "model/surface.h"

// Water that stands in the hollows of the ground.

namespace frond {

/// A square piece of ground as heights at points of a grid, row by row; metres.
struct GroundGrid {
  Vec2 low{0};  ///< x, z of the first point
  float cell = 0.08f;
  int side = 0;  ///< points
  std::vector<float> height;
  std::vector<bool> drain;  ///< where water runs off, as into a pond; its rim is one, too

  std::size_t index(int column, int row) const { return static_cast<std::size_t>(row * side + column); }
};

/// The heights as if every hollow were filled to its brim: a priority flood from the drains inward (Barnes,
/// Lehman and Mulla 2014).
std::vector<float> flooded(const GroundGrid& ground);

/// The water that stands there when it is so deep, metres, in each hollow that is deep enough, and up to the
/// brim in others: level faces, which the ground cuts to their shape. Larger depths have faces of which those
/// of smaller ones are a part.
Surface puddles(const GroundGrid& ground, double depth);

/// Depth of puddles when so many millimetres have fallen, metres: what runs together from land four times as
/// wide as they are, up to 4 cm, when it seeps away.
double puddle_depth(double fallen);

}  // namespace frond
