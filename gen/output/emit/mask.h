#pragma once

#include <string>

#include "core/mask.h"
#include "emit/pov.h"

namespace frond {

/// Declares a function of that name which is the mask at a place of POV-Ray's space, as Mask::at() is. The
/// mask has an area.
void declare_mask(std::string& text, const PovSpace& space, const Mask& mask, const std::string& name);

}  // namespace frond
