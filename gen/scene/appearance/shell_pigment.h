#pragma once

#include "appearance/shell_look.h"
#include "core/seed.h"

namespace frond {

// Pigment of shells
// =================
// A shell gets its pigment only at the growing edge, line by line, and keeps every line: the picture is the
// history of a one-dimensional process. An activator produces itself and pigment and consumes a substrate
// that is supplied everywhere at the same rate (Meinhardt and Klingler 1987; Meinhardt 1995,
// activator-depleted substrate):
//
//     da/dt = r s (a^2/(1 + k a^2) + r0) - m a + Da a''        ds/dt = b - r s (a^2/(1 + k a^2) + r0) - v s +
//     Ds s''
//
// Where the substrate diffuses far, the activator settles into stripes along growth; where it does not, the
// activator fires, spreads as a wave and dies out, which draws oblique lines that meet and end each other.

/// The pigment of a pattern that comes by reaction, along an edge of `width` cells, 0..1, one grid row per
/// growth line; the last row is the oldest. A pure function.
Grid pigment(ShellPattern pattern, int width, int lines, Seed seed);

}  // namespace frond
