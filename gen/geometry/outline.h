#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"

namespace frond {

/// The area of a closed outline as a vector: as long as the area, along the side from which the outline runs
/// counter-clockwise (Newell's method). An outline that is not flat counts as its shadow on its mean plane.
Vec3 outline_area(std::span<const Vec3> points);

/// Cuts an outline, which may be concave, into triangles that run as it does (ear clipping, Meisters 1975).
/// Outlines that cross themselves give triangles too, but not predictable ones. Appends to
/// `triangles`, with `offset` added to each index.
void triangulate(std::span<const Vec3> points, std::uint32_t offset,
                 std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace frond
