#pragma once

#include "scene/scene.h"

namespace frond {

/// Sows the organisms that are sown over the ground: fills `scene.copy_sets` and notes where room ran out.
/// Stems keep out of what is `taken`.
void sow_copies(Scene& scene, const Preset& preset, const Grounds& ground, std::vector<Spot> taken);

// For those on bodies, too.

/// Appends a copy whose foot is on a surface that faces there.
void add_copy(Copies& copies, const Organism& organism, Seed seed, DVec3 foot, Vec3 normal, float size,
              std::uint16_t model);
/// Says that only so many copies found room.
std::string room_note(const Organism& organism, std::size_t entry, std::size_t found);

}  // namespace frond
