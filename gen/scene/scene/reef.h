#pragma once

#include "scene/scene.h"

namespace frond {

/// The history of a preset's reef, which it must have. The preset's seed decides it.
ReefHistory reef_history(const Preset& preset);

/// Draws the colonies of a preset's reef over its years as copies that settle, grow, are bleached, die and
/// are gone: adds to `scene.copy_sets`. Each of its species has the models of the organism that it names,
/// alive, bleached and under turf, which are scaled to the width and the height of the colony at any time.
/// What a storm dislodges lies overturned where it has come to rest.
void add_reef(Scene& scene, const Preset& preset, const Grounds& ground, const ReefHistory& history);

}  // namespace frond
