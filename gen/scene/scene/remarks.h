#pragma once

#include "scene/scene.h"

namespace frond {

/// Notes what of a scene does not fit into its setting, such as what stands through the studio's wall, and
/// that nothing of it is in the picture.
void note_fit(Scene& scene);

}  // namespace frond
