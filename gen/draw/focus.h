#pragma once

#include <optional>

#include "scene/scene.h"

namespace frond {

/// Where the camera has to focus so that the organism it names is sharp at a time: on its axis, as deep as
/// what it sees of that organism nearest in a small spot about the middle of the picture, or else about the
/// organism's own middle. None where it names none, has no aperture, or there is nothing of it yet.
std::optional<Vec3> named_focus(const Scene& scene, double time);

}  // namespace frond
