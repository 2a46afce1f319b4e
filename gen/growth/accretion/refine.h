#pragma once

#include <vector>

#include "accretion/accretion.h"

namespace frond {

/// Cuts each triangle into four, `times` times, and rounds the result; its past likewise.
void refine(Accreted& skin, int times);

/// Moves each vertex outward by `height` metres, and at earlier steps by less, as the skin was smaller.
void raise(Accreted& skin, const std::vector<float>& height);

}  // namespace frond
