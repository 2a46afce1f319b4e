#pragma once

#include <CLI/CLI.hpp>

#include "cli/commands.h"
#include "core/result.h"
#include "pipeline/out_folder.h"
#include "settings/scene_setup.h"

// What is asked for is judged before anything is grown or rendered: options that do not go with each other,
// with the preset, or with what there is on the disk.

namespace frond {

/// Lets every command of the program judge its options once they are read: of two that do not go together,
/// and of one that does nothing without another, CLI11 tells as of all wrong words.
void judge_options(CLI::App& app);

/// What of a call of `frond render` does not fit the film of its preset.
Errors judge_render(const RenderArguments& arguments, const Film& film);

}  // namespace frond
