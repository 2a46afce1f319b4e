#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "scene/scene.h"
#include "world/world.h"

namespace frond {

/// Steps of progress while a bed grows: one for each planting, also for those that have yet to find room on
/// bodies; all creepers or fish of an entry grow as one.
std::size_t steps_of(const Bed& bed);

/// Grows the beds of a scene stage by stage and adds them to the world, and to `notes` what is to be said.
Result<CacheUse> grow_stages(const Preset& preset, const std::vector<Bed>& beds, const Surface& floor,
                             const ProgressSink& watch, SpecimenCache* cache, const EntryFilter& only,
                             World& world, std::vector<std::string>& notes);

}  // namespace frond
