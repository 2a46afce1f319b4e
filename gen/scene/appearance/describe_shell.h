#pragma once

#include "appearance/shell_look.h"
#include "preset/describe.h"

// The properties of the look of shells as presets spell them; see preset/describe.h.

namespace frond {

void describe(Properties& v, ShellLook& l);
void describe(Properties& v, MantleLook& m);

}  // namespace frond
