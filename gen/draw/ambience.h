#pragma once

#include <optional>

#include "light/light.h"
#include "scene/scene.h"

namespace frond {

/// Whether light comes from all around in a setting, and not from lamps alone.
bool has_soft_light(const Stage& stage);

/// What shines on a scene from all around; none where there are lamps.
std::optional<Ambience> ambience_of(const Scene& scene);

}  // namespace frond
