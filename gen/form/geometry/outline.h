#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"
#include "model/surface.h"

namespace frond {

/// Triangulates an outline, which may be concave, keeping its orientation (ear clipping, Meisters 1975).
/// Outlines that cross themselves give triangles too, but unpredictable ones. Appends to `triangles`, with
/// `offset` added to each index.
void triangulate(std::span<const Vec3> points, std::uint32_t offset,
                 std::vector<std::array<std::uint32_t, 3>>& triangles);

/// Adds an outline, three points or more, as a flat blade that points from its foot to its farthest corner:
/// `uv` along and across it. One without an area adds nothing.
void add_outline(Surface& surface, std::span<const Vec3> points, Vec3 foot);

}  // namespace frond
