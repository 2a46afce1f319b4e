#pragma once

#include "appearance/fish_look.h"
#include "preset/describe.h"

// The properties of a fish as presets spell them; see preset/describe.h.

namespace frond {

void describe(Properties& v, FishForm& f);
void describe(Properties& v, FishLook& l);

}  // namespace frond
