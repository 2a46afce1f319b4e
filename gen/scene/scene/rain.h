#pragma once

#include "scene/scene.h"

namespace frond {

/// The puddles on the ground of a scene in which it rains, or has rained, as a specimen of the setting; none
/// where no water stands. What is wet is so by its texture, see Traits::wet.
std::optional<Specimen> standing_water(const Scene& scene, const Grounds& ground);

}  // namespace frond
