#pragma once

#include "geometry/ground.h"
#include "scene/scene.h"

namespace frond {

/// Turns, sizes and moves what has grown at the origin to its place.
void put(Branches& branches, Vec3 foot, Quat turn, float size);

/// Takes over what a grower made and puts it at its place.
void settle(Branches& branches, Model&& model, Vec3 foot, Quat turn, float size);

/// Lets each of the solids that ask for it stand as high above the ground below it as it stands above its
/// foot.
void follow_ground(Solids& solids, const Heights& ground, float foot_height);

}  // namespace frond
