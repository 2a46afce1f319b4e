#pragma once

#include <span>
#include <vector>

#include "scene/scene.h"

namespace frond {

/// A tree of a preset and where it stands.
struct TreePlanting {
  const Organism* organism = nullptr;  ///< whose body is a TreeParams
  Seed seed;
  Vec3 foot{0};  ///< metres
};

/// Grows all trees of a preset together, so that they shade each other, among bodies that shade them; one a
/// planting, without the look and the motion. Trees that grow in a film carry their life along. The random
/// size of a place is an age here.
std::vector<Branches> grow_together(const Preset& preset, const std::vector<TreePlanting>& plantings,
                                    std::span<const Surface> bodies);

/// A tree that carries its life as it is at a time, with what falls from it on its way.
Branches tree_at(const Branches& tree, double time);

}  // namespace frond
