#pragma once

#include "model/surface.h"

namespace frond {

/// The same mesh with vertices parted along sharp edges: faces that meet at less than `angle` (radians) share
/// smooth normals, others keep their own. Vertices must be shared by the faces that meet there; those that
/// stand at one place twice part the mesh already. `uv` is carried along.
Surface creased(const Surface& surface, double angle);

}  // namespace frond
