#pragma once

#include <span>
#include <string>
#include <vector>

#include "grove/grove.h"
#include "pruning/edits.h"

namespace frond {

/// The axes of a tree, see pruning/address.h. A branch has the number of the node, counted along the axis
/// that it leaves, at which it grows. Shares are of what stands of an axis in the end. Those that a tree has
/// already are its own, also where it was edited since.
std::vector<AxisNode> axis_nodes(const GrownTree& tree);

/// Turns what is attached to each node about it, and makes the wood there thicker by a factor, in all years.
void turn_wood(GrownTree& tree, std::span<const Quat> turn, std::span<const float> factor);

/// Edits a tree in all years of its life: what is cut was never there, what is bent was bent from the start.
/// Dated cuts are for grow_grove(). Gives notes on what finds no branch, see Reshaped::notes.
std::vector<std::string> edit_tree(GrownTree& tree, std::span<const Edit> edits);

}  // namespace frond
