#pragma once

#include "core/events.h"
#include "organisms/organism.h"
#include "preset/describe.h"

// The properties of all organisms and of dated events, as presets spell them; see preset/describe.h.

namespace frond {

void describe(Properties& v, Event& e);
void describe(Properties& v, Organism& o);

/// Its kind.
void describe_rest(KeyWriter& v, Organism& o);

}  // namespace frond
