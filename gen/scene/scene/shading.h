#pragma once

#include <span>

#include "world/specimen.h"

namespace frond {

/// Finds how much of the light that would come to the skin of stony corals from above is left to it by its
/// neighbours, see Solid::light and Model::light. Branches and bodies of all colonies shade, and branches
/// also others of the same coral: what lies low and within is dead, as in thickets. A body's own folds, and
/// rocks, do not count, since it has grown among them. All as it is when grown.
void shade(std::span<Specimen> specimens);

}  // namespace frond
