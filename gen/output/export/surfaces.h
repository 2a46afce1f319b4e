#pragma once

#include <cstdint>
#include <vector>

#include "model/surface.h"

namespace frond {

/// The surface with `uv` in metres, by the plane of the axes that each triangle faces most; what faces
/// different ways has corners of its own. u lies along x on top and on the sides that face z. `of` is told
/// which vertex each is.
Surface box_mapped(const Surface& surface, std::vector<std::uint32_t>* of = nullptr);

/// Scales `uv` that are metres to pictures so wide and high, and shifts them.
void lay_picture(Surface& surface, double wide, double high, Vec2 shift = Vec2(0));

/// Metres: shorter edges of a body of such voxels are none.
double shortest_edge(double voxel);

/// Takes away the edges of a closed surface that are shorter than `least`, metres, but for those without
/// which an edge would have more than two triangles. `node`, one a vertex, follows.
void join_short_edges(Surface& surface, std::vector<std::int32_t>& node, double least);

}  // namespace frond
