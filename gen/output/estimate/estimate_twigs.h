#pragma once

#include "scene/preset.h"

namespace frond {

/// The share that is left of a plant's text where its twigs are drawn from a palette, see draw/twig_plan.h;
/// 1: they are not. `organs` of each plant. By how far the camera looks: what stands nearer takes more.
double share_of_twigs(const Preset& preset, const Organism& organism, const Appearance& appearance,
                      double organs);

}  // namespace frond
