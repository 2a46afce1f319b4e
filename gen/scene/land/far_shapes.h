#pragma once

#include "core/seed.h"
#include "model/surface.h"

namespace frond {

// What stands on the far land, as plain as it is drawn there. `uv`: u says what it is.

/// A broad-leaved tree of height 1 and about as wide as that: u is 0 on the trunk, from 0.1 inside the crown
/// to 1 at its outside.
Surface far_broadleaf(Seed seed);
/// A conifer of height 1; u as of a broad-leaved tree.
Surface far_conifer(Seed seed);
/// A piece of hedge along x of length 1 and height 1; u as of a broad-leaved tree.
Surface far_hedge(Seed seed);
/// A house with gables toward x, `long_side` by `wide` metres, its eaves `eaves` metres high: u is 0.1 on
/// walls, 0.4 on the roof, 0.6 on the chimney, 0.9 on windows and doors.
Surface far_house(double long_side, double wide, double eaves, Seed seed);

}  // namespace frond
