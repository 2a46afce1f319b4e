#pragma once

#include "scene/scene.h"

namespace frond {

/// Whether an organism with that motion sways in the wind of a scene: trees that have no wave of their own.
bool in_wind(const Motion& motion, const SceneSetup& setup);
/// Whether an organism that is sown sways in the wind of a scene: trees and herbs that have no wave of their
/// own.
bool sown_in_wind(const Organism& organism, const Motion& motion, const SceneSetup& setup);

/// The wind of a scene, with storms or without; none where it is calm.
std::optional<WindField> wind_in(const Scene& scene, std::vector<Gale> gales = {});

/// Lets the trees of a grown scene sway in its wind, if it has one. Storms of its events blow at the second
/// of the film at which their year passes for the first tree that grows in it.
void add_wind(Scene& scene, const Preset& preset);

}  // namespace frond
