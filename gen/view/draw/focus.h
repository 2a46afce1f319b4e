#pragma once

#include <optional>

#include "scene/scene.h"

namespace frond {

/// Where the camera has to focus so that the organism it names is sharp at a time: on its axis, as deep as
/// what it sees of that organism nearest in a small spot about the middle of the picture, or else about the
/// organism's own middle. None where it names none, has no aperture, or there is nothing of it yet.
std::optional<Vec3> named_focus(const Scene& scene, double time);

/// Where a camera focuses that names no organism: on the point it is given, or else on the point it looks at.
Vec3 focus_of(const Camera& camera, double time);
/// Width of the opening of the camera's lens, metres; 0 without an aperture.
double lens_width(const Camera& camera, double time);

}  // namespace frond
