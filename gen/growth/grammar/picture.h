#pragma once

#include <string>
#include <vector>

#include "core/vec.h"
#include "grammar/derive.h"

namespace frond {

/// The derivation tree as SVG: one row per level from the axiom down, a line from each module to each of its
/// successors. A parent is above the middle of its children. Words of more than 2000 modules are refused.
Result<std::string> derivation_tree_svg(const Grammar& grammar, int steps, Seed seed);

/// What a turtle draws, for a picture.
struct TurtleDrawing {
  struct Stroke {
    DVec3 from, to;
    double width;
    int color;
  };
  struct Fill {
    std::vector<DVec3> points;
    int color;
  };
  struct Ball {
    DVec3 center;
    double radius;
    int color;
  };
  std::vector<Stroke> lines;
  std::vector<Fill> fills;
  std::vector<Ball> balls;
  DVec3 low{1e300}, high{-1e300};   ///< the box round it
  std::vector<std::string> colors;  ///< as SVG names them, selected cyclically; at least one
};

/// A drawing seen along the z axis as SVG: lines as wide as branches, filled polygons.
std::string svg_of(const TurtleDrawing& drawing);

/// The drawing after `steps` steps, which may be fractional, as SVG.
Result<std::string> turtle_svg(const Grammar& grammar, double steps, Seed seed, const Limits& limits = {});

}  // namespace frond
