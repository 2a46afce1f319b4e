#pragma once

#include <string>

#include "preset/describe.h"

namespace frond {

/// A range in words, with a blank in front: ` from 0 to 10 metres`, ` above 0`, or nothing where all is
/// allowed. The bounds of float, int and the like go without saying.
std::string range_text(const Range& range);

}  // namespace frond
