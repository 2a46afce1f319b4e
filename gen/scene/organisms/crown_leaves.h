#pragma once

#include <vector>

#include "crown/crown.h"
#include "dress/dress.h"

namespace frond {

/// Places a leaf or sprig of `size` metres (across, along and above) at each site.
void put_leaves(Model& model, const std::vector<LeafSite>& sites, const TreeDress& dress, Vec3 size,
                Seed seed);

}  // namespace frond
