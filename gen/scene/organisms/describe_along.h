#pragma once

#include "crown/along_parent.h"
#include "preset/describe.h"

// Curves along the parent as presets spell them; see preset/describe.h.

namespace frond {

void describe(Properties& v, AlongParent& a);
void describe(Properties& v, BranchesAlong& b);

}  // namespace frond
