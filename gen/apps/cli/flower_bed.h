#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "preset/value.h"

namespace frond {

/// The scene and the organisms of a bed in which the named species stand, the tall ones behind: each as a
/// drift of as many as suit its size, under a morning sun from the side, before a camera that frames them.
/// One plant of each is grown to know its size. An error where a name is no preset or what it grows cannot
/// stand in a bed.
Result<Value> flower_bed(const std::vector<std::string>& names);

}  // namespace frond
