#pragma once

#include "scene/scene.h"

namespace frond {

/// The snow on the ground and on the bodies of a scene in which everything has grown, as a specimen of the
/// setting; no snow, none. On plants it lies by their texture, see Traits::snowy.
std::optional<Specimen> lying_snow(const Scene& scene, Grounds& ground, Seed seed);

}  // namespace frond
