#pragma once

#include <string>

#include "grammar/derive.h"

namespace frond {

/// Which symbol came from which as SVG: one level a row from the axiom down, a line from each module to
/// every one of its successors. A parent stands above the middle of its children. Words of more than 2000
/// modules are refused: they cannot be read.
Result<std::string> derivation_tree_svg(const Grammar& grammar, int steps, Seed seed);

/// What is drawn after so many steps, which need not be whole, seen along the z axis, as SVG: lines as wide
/// as branches, filled polygons, colours by index.
Result<std::string> turtle_svg(const Grammar& grammar, double steps, Seed seed, const Limits& limits = {});

}  // namespace frond
