#pragma once

#include "core/result.h"
#include "draw/branches.h"
#include "emit/pov.h"

namespace frond {

/// The branches of one organism as one body, fused, rough or of cubes as its style says. A fused or rough one
/// bears the textures of the chunks, each vertex that of the chunk it is nearest to, so that they stick to
/// the skin as they do to sweeps. An error where the volume passes the limit of its style.
Result<ObjectText> body_text(const PovSpace& space, const DrawnBranches& branches, std::size_t skin);

}  // namespace frond
