#pragma once

#include "images/raster.h"

namespace frond {

/// Light that the waves of a calm sea focus on the ground, at one moment, as grey levels on a square that
/// fits on itself in both directions. The waves bend each ray by the slope of the surface, so the light at a
/// point is one over the area that its neighbourhood came from; where it came from is found by three steps of
/// iteration. The levels are square roots of the light, 0 none .. 255 eight times that of a plain surface.
struct Caustics {
  int pixels = 256;
  double focus = 0.3;  ///< how strongly the waves focus, 0.2 soft .. 0.5 sharp
  double time = 0;     ///< seconds
  double loop = 0;     ///< seconds after which all waves are where they were; 0: never
};

Raster caustics_picture(const Caustics& caustics);

}  // namespace frond
