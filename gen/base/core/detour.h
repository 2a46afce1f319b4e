#pragma once

#include <functional>
#include <optional>

#include "core/vec.h"

namespace frond {

/// What a limb meets that grows from one place to another: `to` where nothing is in the way, else where the
/// limb ends that bends aside and goes on along the surface, as long as before, and nothing where it cannot
/// go on. The end keeps `clearance` metres from every surface, or about as much as the beginning has. A place
/// inside a body has no way to itself. A pure function; empty: nothing is in the way.
using Detour = std::function<std::optional<Vec3>(Vec3 from, Vec3 to, float clearance)>;

/// Metres between bark and what it grows along.
inline constexpr float kBarkGap = 0.01f;

}  // namespace frond
