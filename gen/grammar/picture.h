#pragma once

#include <string>

#include "grammar/derive.h"

namespace frond {

/// The derivation tree as SVG: one row per level from the axiom down, a line from each module to each of its
/// successors. A parent is above the middle of its children. Words of more than 2000 modules are refused as
/// unreadable.
Result<std::string> derivation_tree_svg(const Grammar& grammar, int steps, Seed seed);

/// The drawing after `steps` steps, which may be fractional, seen along the z axis, as SVG: lines as wide as
/// branches, filled polygons, colours by index.
Result<std::string> turtle_svg(const Grammar& grammar, double steps, Seed seed, const Limits& limits = {});

}  // namespace frond
