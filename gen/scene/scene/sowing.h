#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"
#include "world/world.h"

namespace frond {

/// Sows the organisms that are sown over the ground: fills `scene.copy_sets` and notes where room ran out.
/// Stems keep out of what is `taken`.
void sow_copies(Scene& scene, const Preset& preset, const Grounds& ground, std::vector<Spot> taken);

// What stands on bodies, as `place.on` says.

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

// For all that is sown.

/// Lets copies of what is sown with a `present` come up and go in each year that the scene's `year` passes
/// through: each at a time of its own in the first half of that part of the year and in the second. Without a
/// `year` they stand over the whole film.
void set_copy_lifetimes(Scene& scene, const Preset& preset);

/// Appends a copy whose foot is on a surface that faces there.
void add_copy(Copies& copies, const Organism& organism, Seed seed, DVec3 foot, Vec3 normal, float size,
              std::uint16_t model);
/// Notes where more than a hundredth of an organism's copies found no room.
void note_room(Scene& scene, const Organism& organism, std::size_t entry, std::size_t found);

}  // namespace frond
