#pragma once

#include "foliage/foliage_shapes.h"
#include "organisms/plant/plant.h"

namespace frond {

/// The shape of an organ that its own grammar draws, its foot at the origin, its longest way along the stem
/// one unit. A branch of a single segment is a leaflet, each outline a blade; all other segments are the
/// stem. Lots depend on `seed`. The errors of a grammar that does not compile name its rules; so do those of
/// one that cannot be drawn, or that places organs.
Result<TwigParts> drawn_foliage(const OrganParams& organ, Seed seed);

}  // namespace frond
