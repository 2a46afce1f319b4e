#pragma once

#include "crown/along_parent.h"
#include "crown/axes.h"
#include "grammar/guide.h"
#include "preset/describe.h"

// What kinds of trees have in common.

namespace frond {

/// A guide of a tree: places that its stem is led through, and where it forks.
struct TreeGuide : GuideText {};

void describe(Properties& v, TreeGuide& g);

/// Its axes; none of an empty guide. An error where points carry more than places.
Result<GuideAxes> axes_of_guide(const TreeGuide& guide);

/// What is wrong with it, below `/guide`.
Errors check_guide(const TreeGuide& guide);

// Curves along the parent as presets spell them; see preset/describe.h.
void describe(Properties& v, AlongParent& a);
void describe(Properties& v, BranchesAlong& b);

}  // namespace frond
