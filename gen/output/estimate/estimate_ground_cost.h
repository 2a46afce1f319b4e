#pragma once

#include "estimate/estimate_cost.h"

namespace frond {

/// What a setting takes by itself, with nothing grown in it.
struct GroundCostEstimate {
  double bytes = 0, memory = 0, seconds = 0;  ///< of its text; that it holds; to lay and write it
  /// Cost of soft light: bytes of its file, bytes held and seconds while it is worked out; 0 where lamps
  /// shine.
  double light_bytes = 0, light_memory = 0, light_seconds = 0;
  double pictures = 0;         ///< bytes of the pictures that each frame has of its own
  double picture_seconds = 0;  ///< seconds to draw these pictures
  double tracing = 1;          ///< share of the time that rays take where there are such pictures
};

/// `tall`: metres to which things rise from it; `crowded`: whether what is sown fills the view; `standing`:
/// triangles of all bodies that stand on it. The ground is laid and its text written, unless that is
/// estimated to take more than a moment; how large the grids of light are follows from the camera.
GroundCostEstimate estimate_ground_cost(const Preset& preset, double tall, bool crowded, double standing);

/// About how tall things in the preset are: as its camera sees them, where they do not know it themselves.
double tallest_of(const Preset& preset);

}  // namespace frond
