#pragma once

#include "geometry/ground.h"
#include "geometry/scatter.h"
#include "scene/scene.h"

namespace frond {

/// Metres, the side of the square that is sown in a setting.
double sown_size(const Stage& stage);

/// Sows the organisms that are sown over the ground of the scene, whose setting and plot are set: fills
/// `scene.stands` and notes where room ran out. Stems keep out of what is `taken`.
void sow_stands(Scene& scene, const Preset& preset, const Heights& heights, std::vector<Spot> taken);

}  // namespace frond
