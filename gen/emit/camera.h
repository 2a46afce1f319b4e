#pragma once

#include <string>

#include "emit/pov.h"
#include "settings/stage.h"

namespace frond {

/// The camera as POV-Ray has it, with its lens.
std::string camera_text(const PovSpace& space, const Camera& camera, Quality quality, double time);

/// How its picture is finished, for the first line of a scene; empty where POV-Ray does all.
std::string tone_text(const Camera& camera);

}  // namespace frond
