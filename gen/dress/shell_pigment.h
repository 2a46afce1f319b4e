#pragma once

#include "core/seed.h"
#include "images/raster.h"

namespace frond {

// Pigment of shells
// =================
// A shell is painted at its growing edge alone, line by line, and keeps every line: the picture is the diary
// of a process in one dimension. An activator makes itself and pigment and uses up a substrate that comes
// everywhere at the same rate (Meinhardt and Klingler 1987; Meinhardt 1995, activator-depleted substrate):
//
//     da/dt = r s (a^2/(1 + k a^2) + r0) - m a + Da a''        ds/dt = b - r s (a^2/(1 + k a^2) + r0) - v s +
//     Ds s''
//
// Where the substrate spreads far, the activator comes to rest in stripes along growth; where it does not,
// the activator fires, spreads as a wave and dies out, which draws oblique lines that meet and end each
// other.

enum class PigmentRegime {
  stripes,  ///< at rest: lines along growth
  lines,    ///< all fire together: lines along the edge
  zigzag,   ///< waves that meet: oblique lines, as on olives
  tents,    ///< the same with pigment that fades slowly: triangles, as on cones
  spots     ///< what fires spreads little
};

/// The pigment along an edge of `width` cells, 0..1, one row for each growth line from the oldest, which is
/// the last row of the grid, to the youngest. A pure function.
Grid pigment(PigmentRegime regime, int width, int lines, Seed seed);

}  // namespace frond
