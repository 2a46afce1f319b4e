#pragma once

#include "core/seed.h"
#include "model/surface.h"

namespace frond {

/// Drops of dew on the upper side of an organ, the side of its normals: `drops` per square centimetre of an
/// organ whose unit is `size` metres long, 0.5 to 2.8 mm across, not overlapping, at most 4000.
Surface dew_surface(const Surface& organ, double size, double drops, Seed seed);

}  // namespace frond
