#pragma once

#include "scene/scene.h"

namespace frond {

/// Sows the organisms that are sown over the ground: fills `scene.copy_sets` and notes where room ran out.
/// Stems keep out of what is `taken`.
void sow_copies(Scene& scene, const Preset& preset, const Grounds& ground, std::vector<Spot> taken);

}  // namespace frond
