#pragma once

#include "scene/scene.h"

namespace frond {

/// Notes of a scene in the studio what stands through its wall, and round its main light.
void note_studio(Scene& scene);

}  // namespace frond
