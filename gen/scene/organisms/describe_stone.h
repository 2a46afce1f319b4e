#pragma once

#include "organisms/stone_look.h"
#include "preset/describe.h"
#include "rocks/rock.h"

// The properties of everything made of stone, as presets spell them; see preset/describe.h.

namespace frond {

void describe(Properties& v, Blob& b);
void describe(Properties& v, Weathering& w);
void describe(Properties& v, StoneLook& s);

/// All properties of a shape except its size.
void describe_shape(Properties& v, RockShape& s);

}  // namespace frond
