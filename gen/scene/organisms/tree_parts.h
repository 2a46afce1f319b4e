#pragma once

#include <vector>

#include "appearance/appearance.h"
#include "crown/along_parent.h"
#include "crown/axes.h"
#include "crown/crown.h"
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
void describe(Properties& v, BranchesAlong& b);

/// Places a leaf or sprig of `size` metres (across, along and above) at each site.
void put_leaves(Model& model, const std::vector<LeafSite>& sites, const TreeAppearance& appearance, Vec3 size,
                Seed seed);

}  // namespace frond
