#pragma once

#include "core/vec.h"
#include "model/surface.h"

namespace frond {

/// A distant mountain range, at right angles to the view from the origin.
struct MountainShape {
  double height = 900;     ///< metres, of its top above the plain
  double distance = 5000;  ///< metres from the origin to its crest
  double width = 7000;     ///< metres from end to end
  double toward = 180;     ///< direction, degrees: 0 toward +z, 90 toward +x
  double snow = 1e5;       ///< metres above the plain where snow begins
  double woods = 0.45;     ///< share of the height covered with woods
  Color rock{0.54f, 0.53f, 0.50f};
  int seed = 1;  ///< of its ridges
};

/// Ridges and gullies from erosion of rising land (the stream power law, solved as by Braun and Willett
/// 2013), seen from the origin. `uv`: u is the light that arrives, 0 sky light where little sky is visible, 1
/// full sun; v the surface: 0 wood, 1/3 scree, 2/3 rock, 1 snow. `sun` points toward the sun, of length 1.
Surface mountain_surface(const MountainShape& shape, Vec3 sun);

}  // namespace frond
