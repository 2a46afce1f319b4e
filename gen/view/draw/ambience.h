#pragma once

#include <optional>

#include "light/light.h"
#include "scene/scene.h"

namespace frond {

/// The error_bound of POV-Ray's radiosity that the soft light reckons with: it uses a place's light again
/// within the place's radius times this.
inline constexpr double kLightErrorBound = 4;

/// Whether light comes from all around in a setting, and not from lamps alone.
bool has_soft_light(const SceneSetup& setup);

/// What shines on a scene from all around at a time; none where there are lamps.
std::optional<Ambience> ambience_of(const Scene& scene, double time);

}  // namespace frond
