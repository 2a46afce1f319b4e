#pragma once

#include "model/skeleton.h"
#include "organisms/colony.h"

namespace frond {

/// Turns branches from what stands near, neighbours' territories and bodies, and ends those that would come
/// into it. Segments keep their lengths. Nothing changes where there is room.
void keep_to_room(Skeleton& skeleton, const Surroundings& around);

}  // namespace frond
