#pragma once

#include "core/events.h"
#include "preset/describe.h"

// Dated events as presets spell them; see preset/describe.h.

namespace frond {

void describe(Properties& v, Cut& c);
void describe(Properties& v, Prune& p);
void describe(Properties& v, Event& e);

}  // namespace frond
