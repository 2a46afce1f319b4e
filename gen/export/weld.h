#pragma once

#include <cstdint>
#include <vector>

#include "model/surface.h"

namespace frond {

/// Metres: shorter edges of a body of such voxels are none.
double shortest_edge(double voxel);

/// Makes one vertex of both ends of each edge that is shorter than `least`, metres; faces that have no area
/// then go, and so do pairs of faces that lie back to back. What was closed stays so. `node`, one a vertex,
/// follows.
void join_short_edges(Surface& surface, std::vector<std::int32_t>& node, double least);

}  // namespace frond
