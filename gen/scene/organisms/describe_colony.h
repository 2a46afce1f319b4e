#pragma once

#include "accretion/accretion.h"
#include "appearance/describe.h"
#include "organisms/colony.h"
#include "organisms/tissue_look.h"
#include "preset/describe.h"

// The properties that colonies share, as presets spell them; see preset/describe.h.

namespace frond {

void describe(Properties& v, TissueLook& t);

}  // namespace frond
