#pragma once

#include <optional>
#include <string>

#include "emit/pov.h"
#include "settings/stage.h"

namespace frond {

/// The camera as POV-Ray has it, with its lens. `focus`: in place of the point that the preset gives.
std::string camera_text(const PovSpace& space, const Camera& camera, Quality quality, double time,
                        std::optional<Vec3> focus = {});

/// How its picture is finished, for the first line of a scene; empty where POV-Ray does all. With several
/// exposures of a frame, the first says of how many its picture is the mean.
std::string tone_text(const Camera& camera, int exposure = 1, int exposures = 1);

}  // namespace frond
