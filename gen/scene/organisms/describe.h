#pragma once

#include "organisms/organism.h"
#include "organisms/sowing.h"
#include "preset/describe.h"

// The properties of all organisms, as presets spell them; see preset/describe.h.

namespace frond {

void describe(Properties& v, Warmth& w);
void describe(Properties& v, SowRules& s);
void describe(Properties& v, CopyTint& t);
void describe(Properties& v, Sowing& s);
void describe(Properties& v, Stance& s);
void describe(Properties& v, Place& p);
void describe(Properties& v, Style& s);
void describe(Properties& v, Organism& o);

/// Its kind.
void describe_rest(KeyWriter& v, Organism& o);

}  // namespace frond
