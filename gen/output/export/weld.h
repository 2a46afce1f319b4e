#pragma once

#include <cstdint>
#include <vector>

#include "model/surface.h"

namespace frond {

/// Metres: shorter edges of a body of such voxels are none.
double shortest_edge(double voxel);

/// Takes away the edges of a closed surface that are shorter than `least`, metres, but for those without
/// which an edge would have more than two triangles. `node`, one a vertex, follows.
void join_short_edges(Surface& surface, std::vector<std::int32_t>& node, double least);

}  // namespace frond
