#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"

namespace frond {

/// The area vector of a polygon: its length is the area, its direction the side from which it runs
/// counter-clockwise (Newell's method).
DVec3 polygon_area(std::span<const DVec3> points);

/// A polygon of three corners or more as triangles that together cover just what it encloses, in its
/// orientation: concave ones, those in any plane, and those whose outline touches itself, such as one with a
/// hole that is reached through a slit. Of the ways to cut it, the one with the shortest cuts. What is not
/// flat is cut as it looks along its area; of an outline that crosses itself as little is turned over as can
/// be. False where more than 2000 corners are so entangled that no ear can be cut off.
[[nodiscard]] bool triangulate_polygon(std::span<const DVec3> points,
                                       std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace frond
