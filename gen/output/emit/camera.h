#pragma once

#include <optional>
#include <string>

#include "emit/pov.h"
#include "settings/scene_setup.h"

namespace frond {

/// The camera as POV-Ray has it, with its lens. `focus`: in place of the point that the preset gives. With
/// a `shift`, in pixels to the right and down, each ray goes through that place of its pixel.
std::string camera_text(const PovSpace& space, const Camera& camera, const Film& film, double time,
                        std::optional<Vec3> focus = {}, Vec2 shift = Vec2(0));

/// Which part of its picture is drawn and how that is finished, for the first line of a scene; empty where
/// POV-Ray does all. With several exposures of a frame, the first says of how many its picture is the mean.
std::string tone_text(const Film& film, const Camera& camera, int exposure = 1, int exposures = 1);
/// Which air `frond resolve` adds to a raw frame, for the same line.
std::string mist_text(const Film& film, const SceneSetup& setup, double time);

}  // namespace frond
