#pragma once

#include <string>

#include "emit/pov.h"
#include "scene/scene.h"

namespace frond {

/// What rain adds to a setting at a time: the textures of water on things, the rings on it, and mist.
std::string rain_text(const Scene& scene, double time);

/// The drops that show at a time, as one mesh; none where it does not rain.
std::string streaks_text(const PovSpace& space, const Scene& scene, double time);

}  // namespace frond
