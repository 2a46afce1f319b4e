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

}  // namespace frond
