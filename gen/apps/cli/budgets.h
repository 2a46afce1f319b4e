#pragma once

#include <filesystem>
#include <vector>

#include "cli/commands.h"
#include "jobs/jobs.h"
#include "scene/preset.h"

namespace frond {

/// Budgets of growth that a preset gives in seconds, as numbers of internodes: those that the film in a
/// folder was generated with before, others by the pace at which one such tree grows now.
Result<std::vector<Manifest::Budget>> counted_budgets(const PresetArguments& arguments, const Preset& preset,
                                                      const std::filesystem::path& film);

/// What sets such a budget, as `--set` has it.
std::string set_of(const Manifest::Budget& budget);

}  // namespace frond
