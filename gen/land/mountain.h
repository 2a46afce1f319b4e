#pragma once

#include "core/seed.h"
#include "core/vec.h"
#include "model/surface.h"

namespace frond {

/// A range that stands far off across the way to it.
struct MountainShape {
  double height = 900;     ///< metres, of its top above the plain
  double distance = 5000;  ///< metres from the origin to its crest
  double width = 7000;     ///< metres from end to end
  double toward = 180;     ///< degrees: 0 toward +z, 90 toward +x
  double snow = 1e5;       ///< metres above the plain from which snow lies
  double woods = 0.45;     ///< share of the height that woods climb
  Color rock{0.54f, 0.53f, 0.50f};
  int seed = 1;  ///< of its ridges
};

/// Ridges and gullies as rain cuts them into what rises (the stream power law, solved as by Braun and Willett
/// 2013), seen from the origin. `uv`: u the light that comes to it, 0 that of the sky where it sees little of
/// it, 1 full sun; v what lies there: 0 wood, 1/3 scree, 2/3 rock, 1 snow. `sun` is toward the sun, of
/// length 1.
Surface mountain_surface(const MountainShape& shape, Vec3 sun);

}  // namespace frond
