#pragma once

#include <string>

#include "draw/surfels.h"
#include "emit/pov.h"
#include "light/light.h"
#include "scene/scene.h"

namespace frond {

/// How large the grids are that the soft light of a scene's ground is worked out in, with things on it that
/// rise to `tall` metres.
SoftLight::Size estimate_light(const Scene& scene, double tall);

/// Whether the soft light is another in each frame: where something grows or becomes another shape, or the
/// sun moves. What only sways keeps that of the first frame.
bool light_changes(const Scene& scene);

/// The soft light of a scene at a time, as POV-Ray's radiosity keeps it in files (+RFI): each line a place, a
/// direction and the light that comes from the half of all directions round it. Empty where the setting
/// brings lamps of its own instead.
Result<std::string> soft_light_text(const PovSpace& space, const Scene& scene, const Surfels& surfels,
                                    double time);

}  // namespace frond
