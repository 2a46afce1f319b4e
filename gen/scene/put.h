#pragma once

#include "scene/scene.h"

namespace frond {

/// Turns, sizes and moves what has grown at the origin to its place.
void put(Branches& branches, Vec3 foot, Quat turn, float size);

}  // namespace frond
