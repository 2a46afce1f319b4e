#pragma once

#include "core/result.h"
#include "organisms/organism.h"

namespace frond {

/// What is wrong with the edits of an organism; each `where` is a pointer below it.
Errors edit_faults(const Organism& organism);

/// Edits of plants that there are not.
Errors edit_warnings(const Organism& organism);

}  // namespace frond
