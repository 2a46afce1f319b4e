#pragma once

#include <string>

#include "cli/commands.h"
#include "core/result.h"
#include "settings/scene_setup.h"

namespace frond {

/// The size in pixels that `--print` and `--dpi` ask for, as what sets it; one side keeps the film's aspect.
Result<std::string> printed_size(const PresetArguments& arguments, const Film& film);

/// Sets what the options say of how pictures are written; `film` has its size.
Errors set_pictures(const PresetArguments& arguments, Film& film);

}  // namespace frond
