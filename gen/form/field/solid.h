#pragma once

#include <functional>

#include "core/result.h"
#include "field/blocks.h"
#include "model/implicit.h"

namespace frond {

/// Fills the distances of the block of 8 x 8 x 8 voxels whose first one is given, z fastest, negative inside.
/// They may be left as they are unless the block is crossed.
using BlockFiller = std::function<Filling(Cell first, std::span<float, kBlockVoxels> distance)>;

/// The surface of a solid inside a box by dual contouring (Ju et al. 2002, as in OpenVDB's VolumeToMesh):
/// closed, triangles of a voxel's size, normals from them. `fill` is called from several threads; the result
/// is the same for any number of them.
Result<Surface> solid_surface(const Box& box, double voxel, const BlockFiller& fill);

}  // namespace frond
