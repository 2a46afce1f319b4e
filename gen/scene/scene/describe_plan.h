#pragma once

#include "plan/plan.h"
#include "preset/describe.h"

// The properties of plans, as presets spell them; see preset/describe.h.

namespace frond {

void describe(Properties& v, RoomKind& r);
void describe(Properties& v, PlanText& p);

}  // namespace frond
