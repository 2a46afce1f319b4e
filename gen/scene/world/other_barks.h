#pragma once

#include <span>

#include "appearance/appearance.h"
#include "pruning/edits.h"

namespace frond {

/// Adds to the look of a plant the barks that edits give to single branches, in the order of the edits, as
/// color_barks() counts them.
void add_other_barks(BranchLook& look, std::span<const Edit> edits);

/// Whether the bark changes on the way along a branch. Then no node of it may be left out, or the bark would
/// change elsewhere.
bool bark_changes_within(const BranchLook& look, const Model& model);

}  // namespace frond
