#pragma once

#include "model/surface.h"

namespace frond {

/// A mesh with vertices split along sharp edges: faces that meet at less than `angle` (radians) share smooth
/// normals, others get their own. Vertices must be shared by adjacent faces; duplicate positions already act
/// as sharp edges. `uv` is kept. `source` receives, for each new vertex, the vertex of `surface` that it was.
Surface creased(const Surface& surface, double angle, std::vector<std::uint32_t>* source = nullptr);

}  // namespace frond
