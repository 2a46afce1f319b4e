#pragma once

#include <vector>

#include "appearance/appearance.h"
#include "crown/crown.h"

namespace frond {

/// Places a leaf or sprig of `size` metres (across, along and above) at each site.
void put_leaves(Model& model, const std::vector<LeafSite>& sites, const TreeAppearance& appearance, Vec3 size,
                Seed seed);

}  // namespace frond
