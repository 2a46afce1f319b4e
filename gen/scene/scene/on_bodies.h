#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"
#include "world/world.h"

// What stands on bodies, as `place.on` says.

namespace frond {

/// Before colonies grow: those that stand on bodies (`place.on`) get their feet there, the first where a
/// plumb line over their place meets one, the others scattered over what does not face downward; and all
/// claim their share of space in the world. An error, at a pointer into the preset, where a body that is
/// named does not stand there. `notes` takes what found no room.
Errors settle_colonies(const Preset& preset, std::vector<Bed>& beds, World& world,
                       std::vector<std::string>& notes);

/// Sows those with `place.on` over the bodies that have grown: by the rules of `sown.where`, of which `clear`
/// and `altitude` do not count. Copies of a layer keep apart in space, and from colonies. An error's `where`
/// is a pointer into the preset.
Errors sow_on_bodies(Scene& scene, const Preset& preset, const World& world);

}  // namespace frond
