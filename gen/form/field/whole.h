#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "field/branch_volume.h"
#include "model/surface.h"

namespace frond {

/// Marks the triangles of a closed mesh that are outer surfaces of bodies: of each root the largest connected
/// piece. The others are inner voids, which are inside out, and detached specks. Triangles that share
/// vertices are connected; `node` is, of each vertex, that of the nearest cone.
std::vector<bool> outsides(const Surface& surface, std::span<const std::int32_t> node,
                           const BranchVolume& boughs);

}  // namespace frond
