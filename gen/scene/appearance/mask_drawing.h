#pragma once

#include "appearance/leaf_look.h"
#include "core/mask.h"

namespace frond {

/// The picture of a mask, which is not empty, for frames that use it.
Drawing mask_drawing(const Mask& mask);

}  // namespace frond
