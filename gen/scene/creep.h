#pragma once

#include "geometry/ground.h"
#include "scene/scene.h"

namespace frond {

/// Grows all ivy of the preset over the bodies that stand in a scene already, and adds it to them; `height`
/// is that of the ground at x, z. Ivy does not grow on ivy.
Errors creep(const Preset& preset, Scene& scene, const Heights& heights);

}  // namespace frond
