#pragma once

#include "scene/preset.h"
#include "settings/setting.h"

namespace frond {

// Numbers of a preset that may be by themselves, but would make too much of something. Each error says the
// figure and what would do; `where` is the JSON pointer of what to change.

/// What all organisms of a kind would take together.
Errors too_much_together(const Preset& preset);

/// More plants than there is room for, however they stood.
Errors without_room(const Preset& preset);

/// Metres that something of that place keeps free round itself.
double room_of(const Place& place, const Extent& extent);

/// How far from the middle anything may stand that is not sown, the camera included; metres.
double reach_of(const Preset& preset);
double reach_of(const Camera& camera);

}  // namespace frond
