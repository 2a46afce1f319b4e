#pragma once

#include <string>

#include "emit/pov.h"
#include "scene/scene.h"

namespace frond {

/// The `#include` lines of the files that a scene needs.
std::string includes_text(const Scene& scene);

/// The surroundings as the camera sees them at one time: light, air and backdrop.
std::string setting_text(const Scene& scene, double time);

/// The ground with what lies or stands on it; the same in each frame.
std::string ground_text(const PovSpace& space, const Scene& scene);

}  // namespace frond
