#pragma once

#include "core/seed.h"
#include "model/surface.h"

namespace frond {

/// Drops of dew on the upper side of an organ, that along its normals: `drops` on a square centimetre of an
/// organ whose unit is `size` metres long, of 0.5 to 2.8 mm across, none in another, at most 4000.
Surface dew_surface(const Surface& organ, double size, double drops, Seed seed);

}  // namespace frond
