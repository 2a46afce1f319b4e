#pragma once

#include "field/volume.h"

namespace frond {

/// Moves the vertices of a mesh onto the exact surface of the boughs, by less than a voxel, and sets their
/// normals and nodes. So the mesh of a moving body moves smoothly, whatever its triangles are.
void settle(const Boughs& boughs, const Blocks& blocks, FusedMesh& mesh);

}  // namespace frond
