#pragma once

#include <string>

#include "emit/pov.h"
#include "scene/scene.h"

namespace frond {

/// The air before the far land and the time of its year, as a frame has them. The scene must have far land.
std::string far_air_text(const Scene& scene, double time);

/// The far land with all that stands on it, the same in each frame.
std::string far_text(const PovSpace& space, const Scene& scene);

}  // namespace frond
