#pragma once

#include "core/events.h"
#include "organisms/organism.h"
#include "preset/describe.h"

// The properties of all organisms, of edits by hand and of dated events, as presets spell them; see
// preset/describe.h.

namespace frond {

void describe(Properties& v, Warmth& w);
void describe(Properties& v, SowRules& s);
void describe(Properties& v, CopyTint& t);
void describe(Properties& v, Sowing& s);
void describe(Properties& v, Stance& s);
void describe(Properties& v, Place& p);
void describe(Properties& v, Style& s);
void describe_rest(KeyWriter& v, Address& address);
void describe(Properties& v, Edit& e);
void describe(Properties& v, Cut& c);
void describe(Properties& v, Prune& p);
void describe(Properties& v, Event& e);
void describe(Properties& v, Organism& o);

/// Its kind.
void describe_rest(KeyWriter& v, Organism& o);

}  // namespace frond
