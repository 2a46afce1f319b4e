#pragma once

#include <string>

#include "core/result.h"
#include "passes/frame_passes.h"

namespace frond {

/// The passes of a frame as the bytes of an OpenEXR picture, with masks of entries, organisms and parts as
/// Cryptomatte has them; docs/data.md names its channels.
Result<std::string> pass_picture(const Scene& scene, const FramePasses& passes);

}  // namespace frond
