#pragma once

#include "land/ground.h"
#include "scene/preset.h"

namespace frond {

/// The camera with its heights, and those of what it looks at, counted from the ground below: as it goes over
/// hill and dale, small bumps smoothed.
Camera over_ground(const Camera& camera, const Heights& heights);

/// What to say of a camera that goes under the ground while the film lasts; empty where it does not.
std::string under_ground(const Camera& camera, const Film& film, const Heights& heights);

}  // namespace frond
