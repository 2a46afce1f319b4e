#pragma once

#include "scene/scene.h"

namespace frond {

/// Rings of the mesh of the snow on the ground, as of a GroundDisc.
int snow_rings(Quality quality);

/// The bodies of a scene near its camera, as falling snow meets them.
CoverGrid bodies_overhead(const Scene& scene);

/// Lays snow on the branches of what has grown, and says when it comes down from them.
void load_boughs(Scene& scene, const Preset& preset);

/// The snow on the ground and on the bodies of a scene in which everything has grown, as a specimen of the
/// setting; no snow, none. Its `overhead` is known. On plants it lies by their texture, see Traits::snowy.
std::optional<Specimen> lying_snow(const Scene& scene, Grounds& ground, Seed seed);

}  // namespace frond
