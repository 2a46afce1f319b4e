#pragma once

#include "core/mask.h"
#include "dress/leaf_look.h"

namespace frond {

/// The picture of a mask, which is not empty, for frames that use it.
Drawing mask_drawing(const Mask& mask);

}  // namespace frond
