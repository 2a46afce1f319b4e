#pragma once

#include <string>
#include <vector>

#include "organisms/organism.h"
#include "scene/preset.h"
#include "world/world.h"

namespace frond {

/// Before colonies grow: those that stand on bodies (`place.on`) get their feet there, the first where a
/// plumb line over their place meets one, the others scattered over what does not face downward; and all
/// claim their share of space in the world. An error, at a pointer into the preset, where a body that is
/// named does not stand there. `notes` takes what found no room.
Errors settle_colonies(const Preset& preset, std::vector<Bed>& beds, World& world,
                       std::vector<std::string>& notes);

}  // namespace frond
