#pragma once

#include "land/plot.h"
#include "settings/meadow.h"

namespace frond {

/// What a garden has beside the lawn and the sky of a meadow, whose colours the hour gives here.
struct Garden {
  double hour = 10;  ///< of the day: 6 dawn, 12 noon, 19 dusk
  double south = 0;  ///< radians; where the sun stands at noon: 0 toward +z, to the right from there
  PondShape pond;
  PathShape path;
  int lilies = 0;        ///< leaves of water lilies on the pond
  double gravel = 0.05;  ///< metres, the stones of the path
  Color gravel_color{0.62f, 0.57f, 0.49f};
};

}  // namespace frond
