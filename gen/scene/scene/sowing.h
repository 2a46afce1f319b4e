#pragma once

#include "scene/scene.h"

namespace frond {

/// Sows the organisms that are sown over the ground: fills `scene.stands` and notes where room ran out. Stems
/// keep out of what is `taken`.
void sow_stands(Scene& scene, const Preset& preset, const Grounds& ground, std::vector<Spot> taken);

}  // namespace frond
