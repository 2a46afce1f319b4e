#pragma once

#include <string>
#include <vector>

#include "scene/preset.h"

namespace frond {

/// A number of a preset that may be by itself, but would make too much of something.
struct Excess {
  std::string pointer;  ///< JSON pointer of what to change
  std::string what;     ///< the figure, and what would do
};

/// Grass, gravel, paths and litter that neither the memory nor POV-Ray could hold.
std::vector<Excess> beyond_bounds(const Preset& preset);

/// Metres that something of that place keeps free round itself.
double room_of(const Place& place, Setting setting);

/// How far from the middle anything may stand that is not sown, the camera included; metres.
double reach_of(const Preset& preset);

/// More plants than there is room for, however they stood.
std::vector<Excess> without_room(const Preset& preset);

}  // namespace frond
