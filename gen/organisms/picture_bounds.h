#pragma once

#include "core/result.h"
#include "organisms/crown_tree.h"
#include "organisms/tree.h"

namespace frond {

/// Pictures of bark and leaves of more pixels than one file is to have. Errors stand at the pointer within
/// the organism.
Errors check_pictures(const TreeDress& dress);
Errors check_pictures(const TreeParams& tree);

}  // namespace frond
