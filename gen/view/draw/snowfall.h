#pragma once

#include "draw/rain.h"

namespace frond {

/// The flakes near the camera that show, as streaks with round ends: as long as they fall while the shutter
/// is open, and as wide as a lens of 8 mm draws what it is not focused on. Those of like size fall as one, so
/// that they come from and go to where none is seen; each sways of its own. A pure function of the time,
/// which repeats with the film where the wind does. All others are the grey of the air.
std::vector<Streak> snow_flakes(const Scene& scene, double time);

/// The powder of boughs that have dropped their snow, the same.
std::vector<Streak> snow_powder(const Scene& scene, double time);

}  // namespace frond
