#pragma once

#include "draw/polyps.h"
#include "emit/pov.h"

namespace frond {

/// One union of them, as open as they are at a time.
ObjectText polyps_text(const PovSpace& space, const DrawnPolyps& drawn, double time);

}  // namespace frond
