#pragma once

#include <vector>

#include "grove/light.h"
#include "model/surface.h"

namespace frond {

/// The shade that a body, closed or not, casts on trees beside and below it. It is cut into cells of a
/// quarter of a voxel, so that thin walls and pebbles shade by their true size. A wide roof leaves a fifth of
/// the light, a tall wall about half of it close to its foot.
std::vector<Shade> shades_of_body(const Surface& body, const LightLaw& law);

}  // namespace frond
