#pragma once

#include <string>

#include "preset/describe.h"

namespace frond {

/// A range in words, with a leading blank: ` from 0 to 10 metres`, ` above 0`, or nothing if there are no
/// limits. The bounds of float, int and the like are omitted.
std::string range_text(const Range& range);

}  // namespace frond
