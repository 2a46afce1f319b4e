#pragma once

#include "core/assets.h"
#include "grammar/guide.h"

namespace frond {

/// The lines of a file that a guide names: the `l` elements of a Wavefront OBJ text, or a skeleton as SWC,
/// its main way first; which of them it is counts by what it holds.
Result<GuideLines> read_guide_file(const NamedFile& file);

}  // namespace frond
