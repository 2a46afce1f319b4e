#pragma once

#include <span>
#include <string>
#include <string_view>

#include "draw/rain.h"
#include "emit/pov.h"

namespace frond {

enum class StreakEnd {
  cut,   ///< quads
  round  ///< triangles whose `uv` have the streak as the disc of radius 1 about their origin
};

/// Streaks that face the eye, as one mesh. `macro`, called with the light and a share of it, stands in their
/// textures.
std::string streak_mesh_text(const PovSpace& space, std::span<const Streak> streaks, Vec3 eye, StreakEnd end,
                             std::string_view macro, Vec3 light);

}  // namespace frond
