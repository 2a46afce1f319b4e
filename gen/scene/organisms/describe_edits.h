#pragma once

#include "preset/describe.h"
#include "pruning/edits.h"

// Edits of branches as presets spell them; see preset/describe.h.

namespace frond {

void describe_rest(KeyWriter& v, Address& address);
void describe(Properties& v, Edit& e);

}  // namespace frond
