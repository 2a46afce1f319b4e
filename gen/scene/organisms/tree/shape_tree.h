#pragma once

#include "crown/along_parent.h"
#include "grove/grove.h"

namespace frond {

/// Shapes the branches of a grown tree by the place where they leave their parent, in all years of its life.
void shape_tree(GrownTree& tree, const BranchesAlong& by);

}  // namespace frond
