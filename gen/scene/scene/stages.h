#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/result.h"
#include "scene/scene.h"
#include "world/world.h"

namespace frond {

/// What came of growing all beds of a scene, but for the specimens, which the world holds.
struct GrownStages {
  std::vector<std::size_t> entries;            ///< those that were not taken from the cache
  std::map<std::size_t, std::string> origins;  ///< of entries, what stands for all that they grew from
  std::vector<std::string> names;              ///< of what stands in the scene, in the cache
  std::vector<std::size_t> missing;            ///< entries that were left out
  std::vector<std::string> notes;
};

/// Steps of progress while a bed grows: one for each planting, also for those that have yet to find room on
/// bodies; all creepers or fish of an entry grow as one.
std::size_t steps_of(const Bed& bed);

/// Grows the beds of a scene stage by stage and adds them to the world.
Result<GrownStages> grow_stages(const Preset& preset, const std::vector<Bed>& beds, const Surface& floor,
                                const ProgressSink& watch, SpecimenCache* cache, const EntryFilter& only,
                                World& world);

}  // namespace frond
