#pragma once

#include "scene/scene.h"

namespace frond {

/// Gives a tree the look and motion of its parameters; how much the brightness of single ones differs.
double wear(Branches& branches, const WeberPennParams& params);
double wear(Branches& branches, const ColonizedParams& params);

}  // namespace frond
