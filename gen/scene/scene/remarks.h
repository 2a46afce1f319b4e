#pragma once

#include "scene/scene.h"

namespace frond {

/// Notes what of a scene does not fit into its setting, such as what stands through the studio's wall, and
/// that nothing of it is in the picture.
void note_fit(Scene& scene);

/// Notes what was found while it grew, at its place in the preset, each once, and what is sown and does not
/// grow though it is to.
void note_growth(Scene& scene, const Preset& preset);

/// Notes a camera that sees nothing but the inside of what stands there, or of the ground.
void note_camera(Scene& scene, const Preset& preset);

}  // namespace frond
