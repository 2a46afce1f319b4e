#pragma once

#include "crown/axes.h"
#include "grammar/guide.h"
#include "preset/describe.h"

namespace frond {

/// A guide of a tree: places that its stem is led through, and where it forks.
struct TreeGuide : GuideText {};

void describe(Properties& v, TreeGuide& g);

/// Its axes; none of an empty guide. An error where points carry more than places.
Result<GuideAxes> axes_of_guide(const TreeGuide& guide);

/// What is wrong with it, below `/guide`.
Errors check_guide(const TreeGuide& guide);

}  // namespace frond
