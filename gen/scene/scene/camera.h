#pragma once

#include "land/ground.h"
#include "scene/preset.h"

namespace frond {

/// The camera with its heights, and those of what it looks at, counted from the ground below: as it goes over
/// hill and dale, small bumps smoothed.
Camera over_ground(const Camera& camera, const Heights& heights);

/// How a camera draws at a time.
struct Lens {
  Vec3 at{0}, right{1, 0, 0}, up{0, 1, 0}, toward{0, 0, -1};  ///< the last three of length 1
  float wide = 1, high = 1;                                   ///< half the picture, a metre before it

  /// Where a place is in the picture, from -1 at its left and lower edge to 1, and its depth in metres.
  Vec3 seen(Vec3 place) const;
};

/// `aspect`: height of the picture by its width.
Lens lens_at(const Camera& camera, double time, double aspect);

/// The place on the ground before the camera, halfway along its way, x and z, and how far its way leads from
/// there, in a film of so many seconds.
std::pair<Vec2, double> seen_ground(const Camera& camera, double length);

}  // namespace frond
