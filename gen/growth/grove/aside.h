#pragma once

#include "core/detour.h"
#include "grove/metamers.h"
#include "grove/species.h"

namespace frond {

/// Moves every tip to where the detour lets it be, by the radius that its internode has now, and what it
/// bears with it: a stem that thickens beside a wall is pushed off it. Of this year's shoots, metamers
/// `first` and after, those of branches that would turn by more than 60 degrees are taken off, and what has
/// no way on.
void bend_aside(Metamers& tree, const Wood& wood, const Detour& detour, std::size_t first);

}  // namespace frond
