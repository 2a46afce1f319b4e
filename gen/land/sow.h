#pragma once

#include <string>
#include <vector>

#include "core/seed.h"
#include "core/vec.h"

namespace frond {

/// Which of the plants that stand above each other keep apart by their crowns.
enum class Layer { canopy, shrubs, herbs };

/// Where plants of one kind come up.
struct SowRules {
  Layer layer = Layer::canopy;
  double radius = 2;         ///< metres, of the crown at size 1: crowns of one layer keep apart by both radii
  double stem = 0.3;         ///< metres that plants of other layers keep free round it
  Vec2 altitude{-1e4, 1e4};  ///< metres, lowest and highest
  double slope = 0.7;        ///< radians, steepest
  double patch = 0;          ///< metres from clump to clump; 0: evenly
  double cover = 1;          ///< share of the land that its clumps cover
  Vec2 shade{0, 1};          ///< least and most share of the sky that crowns above it cover
  double clear = 0.5;        ///< metres that it keeps from the edge of a path
  Vec2 center{0};            ///< x, z in metres
  double reach = 0;          ///< metres round `center`; 0: all of the land
  std::string map;           ///< a PNG whose brightness is the density, laid over the land; empty: none
};

}  // namespace frond
