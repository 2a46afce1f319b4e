#pragma once

#include "field/volume.h"

namespace frond {

/// Moves the vertices of a mesh onto the exact surface of the boughs, by less than a voxel, and sets their
/// normals and nodes. So the mesh of a moving body moves smoothly, whatever its triangles are.
void settle(const BranchVolume& boughs, const Blocks& blocks, FusedMesh& mesh);

/// Sets the nodes of the vertices of a mesh that lies as its boughs do at rest, and gives the way from there
/// to where the branches near each vertex carry it; metres.
std::vector<Vec3> carried_by(const BranchVolume& boughs, const Blocks& blocks, const Carriage& carriage,
                             FusedMesh& mesh);

}  // namespace frond
