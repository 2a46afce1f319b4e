#pragma once

#include "core/curve.h"
#include "land/plot.h"
#include "settings/sky.h"

namespace frond {

/// The additions of a garden to the lawn and the sky of a meadow, with the sun of the hour.
struct Garden {
  Animated<double> hour{10.0};
  Moment when;  ///< its own hour counts for nothing
  PondShape pond;
  PathShape path;
  std::vector<GroundArea> areas;
  int lilies = 0;        ///< number of water lily leaves on the pond
  double gravel = 0.05;  ///< metres, the stones of the path
  double clods = 0.05;   ///< metres, of the earth in beds
  Color gravel_color{0.62f, 0.57f, 0.49f}, earth_color{0.33f, 0.25f, 0.18f};
};

}  // namespace frond
