#pragma once

#include <string>

#include "core/result.h"
#include "land/plot.h"

namespace frond {

/// Errors for paths that are too long, have too many points or leave the land, which reaches `reach` metres
/// from the middle. They are at `pointer`, that of the points.
void check_path(Errors& list, const PathShape& path, const std::string& pointer, double reach);

}  // namespace frond
