#pragma once

#include "core/detour.h"
#include "crown/crown.h"

namespace frond {

/// Moves every node to where the detour lets it be, by its own radius, and what it bears with it; what cannot
/// be anywhere is cut off. Births and distances to tips are left to be set.
void bend_aside(Crown& crown, const Detour& detour);

}  // namespace frond
