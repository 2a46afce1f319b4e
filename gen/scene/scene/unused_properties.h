#pragma once

#include "scene/preset.h"

namespace frond {

/// An angle that is given as so few degrees was meant as radians.
inline constexpr double kRadians = 1.5;

/// The settings that a preset's own file gives, or the command line, and that do nothing in it: of another
/// surrounding, or of a motion that is left at 0. What a base or the defaults bring may be meant for others
/// and is passed over. `preset.written` must be there.
Errors unused_properties(const Preset& preset, const std::string& file_name);

}  // namespace frond
