#pragma once

#include "scene/preset.h"

namespace frond {

/// The history of a preset's stand, which it must have, on the ground that its setting lays. The preset's
/// seed decides it.
StandHistory stand_history(const Preset& preset);
StandHistory stand_history(const Preset& preset, const Grounds& ground);

}  // namespace frond
