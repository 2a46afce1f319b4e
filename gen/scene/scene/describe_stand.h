#pragma once

#include "dynamics/stand.h"
#include "preset/describe.h"

// The properties of stand dynamics, as presets spell them; see preset/describe.h.

namespace frond {

void describe(Properties& v, TreeText& t);
void describe(Properties& v, StandPlanting& p);
void describe(Properties& v, StandText& s);

}  // namespace frond
