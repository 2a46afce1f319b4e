#pragma once

#include "scene/scene.h"

namespace frond {

/// Gives a tree the look and motion of its parameters; how much the brightness of single ones differs.
double wear(Branches& branches, const WeberPennParams& params);
double wear(Branches& branches, const ColonizedParams& params);

/// The picture files that the frames of a preset need.
Result<std::vector<Picture>> draw_pictures(const Preset& preset, const Watch& watch);

}  // namespace frond
