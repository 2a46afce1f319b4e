#pragma once

#include "model/surface.h"

namespace frond {

/// The same mesh with vertices split along sharp edges: faces that meet at less than `angle` (radians) share
/// smooth normals, others get their own. Vertices must be shared by adjacent faces; duplicate positions
/// already act as sharp edges. `uv` is kept.
Surface creased(const Surface& surface, double angle);

}  // namespace frond
