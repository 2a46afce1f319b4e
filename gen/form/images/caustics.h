#pragma once

#include "images/raster.h"

namespace frond {

/// Light focused on the ground by the waves of a calm sea at one moment, as grey levels on a square that
/// tiles in both directions. The waves bend each ray by the slope of the surface, so the light at a point is
/// the inverse of the area scale of its neighbourhood; the origin of its ray is found by three iterations.
/// The levels are square roots of the light, 0 none .. 255 eight times that of a flat surface.
struct Caustics {
  int pixels = 256;
  double focus = 0.3;  ///< how strongly the waves focus, 0.2 soft .. 0.5 sharp
  double time = 0;     ///< seconds
  double loop = 0;     ///< seconds after which the waves repeat; 0: never
};

Raster caustics_picture(const Caustics& caustics);

}  // namespace frond
