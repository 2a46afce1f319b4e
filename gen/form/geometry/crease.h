#pragma once

#include "model/surface.h"

namespace frond {

/// The same mesh with vertices split along sharp edges: faces that meet at less than `angle` (radians) share
/// smooth normals, others get their own. Vertices must be shared by adjacent faces; duplicate positions
/// already act as sharp edges. `uv` is kept. `source` is given the vertex of `surface` that each new one was.
Surface creased(const Surface& surface, double angle, std::vector<std::uint32_t>* source = nullptr);

}  // namespace frond
