#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/events.h"
#include "core/result.h"
#include "dynamics/reef.h"
#include "dynamics/stand.h"
#include "organisms/organism.h"
#include "plan/plan.h"
#include "preset/palettes.h"
#include "scene/taxon.h"
#include "settings/scene_setup.h"

namespace frond {

struct Value;

/// The version that new presets are written in; those that tell none are of version 1.
inline constexpr int kPresetVersion = 2;

/// A preset as the user wrote it: checked, typed, with every default and override in its place.
struct Preset {
  std::string title;
  std::string base;  ///< a preset that this one is laid over, as seen from its folder; empty: none
  std::uint64_t seed = 1;
  std::optional<Taxon> taxon;  ///< what is known of the species of its first organism
  Palettes palettes;
  Film film;
  SceneSetup setup;
  std::vector<Event> events;  ///< in the lives of its trees or colonies
  std::optional<PlanText> plan;
  std::optional<StandText> stand;
  std::optional<ReefText> reef;
  std::vector<Organism> organisms;

  std::string text;                          ///< what it was read from, overrides included, as canonical JSON
  std::shared_ptr<const Value> written;      ///< the same with its places, defaults merged into the organisms
  std::vector<std::filesystem::path> files;  ///< that were read for it, besides its own
  Errors notes;                              ///< no faults, but what the user should know
  int version = 1;   ///< of the rules by which entries take their seeds, see scene/entry_seeds.h
  bool old = false;  ///< its file has what upgrade_preset() carries over
};

/// Reads a preset, and the one that it builds on. `file_name` is for messages and tells the folder; `sets`
/// are `/json/pointer=value` overrides, applied in order; `only` is that of Assets. All faults are reported.
Result<Preset> read_preset(std::string_view text, const std::string& file_name,
                           const std::vector<std::string>& sets,
                           const std::optional<std::filesystem::path>& only = {});

/// What is found wrong with the value at a JSON pointer after reading, with its place.
Error fault_at(const Preset& preset, const std::string& pointer, std::string what);

/// The JSON Schema (draft-07) of presets, made when it is first asked for.
const Value& preset_schema();

}  // namespace frond
