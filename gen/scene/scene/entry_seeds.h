#pragma once

#include <string_view>
#include <vector>

#include "core/seed.h"
#include "scene/preset.h"

namespace frond {

/// The seeds of all entries of a preset for a purpose, by which they are scattered, grow and move. In version
/// 1 an entry's hangs on its index. In version 2 it hangs on its name and on how many of that name stand
/// before it, or without a name on its kind and on how many of that kind without a name stand before it: what
/// is inserted, removed or moved changes no other.
std::vector<Seed> entry_seeds(const Preset& preset, std::string_view purpose);

/// The seed of planting `number` of an entry that has been scattered: in version 2 that of the attempt that
/// found its place, so that one that finds no room any more changes no other.
Seed planting_seed(const Preset& preset, Seed entry, std::string_view found_by, std::uint64_t number,
                   std::uint64_t attempt);

}  // namespace frond
