#pragma once

#include "export/maker.h"

namespace frond {

/// Draws the levels of detail that are pictures, after the materials have theirs: of an organism's leaves
/// some sets of three pictures that cross, seen from the front, the side and above, each of a bough; at the
/// last level one set of the whole, of three sides and the top. As much of them is opaque, and leaves of
/// other levels are as large, as lets them cover what the first level does.
Errors add_crossed_levels(Maker& maker);

}  // namespace frond
