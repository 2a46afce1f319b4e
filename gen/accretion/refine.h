#pragma once

#include <vector>

#include "accretion/accretion.h"

namespace frond {

/// Cuts each triangle into four, `times` over, and rounds what comes of it; its past likewise.
void refine(Accreted& skin, int times);

/// Moves each vertex outward by `height` of it, metres, as much less before as the skin was smaller.
void raise(Accreted& skin, const std::vector<float>& height);

}  // namespace frond
