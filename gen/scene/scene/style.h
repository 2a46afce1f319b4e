#pragma once

#include "core/result.h"
#include "scene/scene.h"

namespace frond {

/// The style with a voxel that suits the size of what has these branches, where it names none.
Style settled(Style style, const Skeleton& rest);

/// Gives each organism the style of its entry, with a voxel that suits its size where that names none. Errors
/// where a volume is refused, which is estimated before anything large is allocated.
Errors resolve_styles(Scene& scene, const Preset& preset);

}  // namespace frond
