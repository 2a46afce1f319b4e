#pragma once

#include "model/skeleton.h"
#include "organisms/colony.h"

namespace frond {

/// Bends branches away from neighbours' territories and existing bodies, and ends those that would enter
/// them. Segments keep their lengths. Nothing changes where there is room.
void keep_to_room(Skeleton& skeleton, const Surroundings& around);

}  // namespace frond
