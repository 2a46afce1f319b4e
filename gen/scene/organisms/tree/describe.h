#pragma once

#include "organisms/tree/tree.h"
#include "preset/describe.h"

// The properties of a tree as presets spell them; see preset/describe.h.

namespace frond {

void describe(Properties& v, Wood& w);
void describe(Properties& v, Species& s);
void describe(Properties& v, LightLaw& l);
void describe(Properties& v, Foliage& f);
void describe(Properties& v, GrowthBudget& b);
void describe(Properties& v, TreeParams& t);

}  // namespace frond
