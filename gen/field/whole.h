#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "field/boughs.h"
#include "model/surface.h"

namespace frond {

/// Which triangles of a closed mesh are the outsides of bodies: those of one connected piece a root, the
/// largest that it has. The others are voids, whose walls are turned inside out, and specks that lie apart.
/// Pieces are told by the vertices that triangles share; `node` is, of each vertex, that of the nearest cone.
std::vector<bool> outsides(const Surface& surface, std::span<const std::int32_t> node, const Boughs& boughs);

}  // namespace frond
