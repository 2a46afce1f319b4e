#pragma once

#include <vector>

#include "grove/light.h"
#include "model/surface.h"

namespace frond {

/// What a body that stands there, closed or not, takes of the light of trees beside and below it. It is cut
/// into cells of a quarter of a voxel, so that a thin wall shades as a wall and a pebble as a pebble. A wide
/// roof leaves a fifth of the light, a tall wall about half of it right beside its foot.
std::vector<Shade> shades_of_body(const Surface& body, const LightLaw& law);

}  // namespace frond
