#pragma once

#include <vector>

#include "light/light.h"
#include "scene/scene.h"

namespace frond {

/// What the camera sees at a time.
Eye eye_at(const Scene& scene, double time);

/// At all frames of the film.
std::vector<Eye> eyes(const Scene& scene);

}  // namespace frond
