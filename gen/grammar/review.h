#pragma once

#include "grammar/grammar.h"

namespace frond {

/// Decomposition rules that can lead to no end: whatever is drawn by lot and whichever conditions hold, what
/// they make is taken apart again. Names one of them.
Errors find_endless(const Grammar& grammar);

/// Symbols that rules make although nothing knows them: no rule rewrites them, and they mean nothing to the
/// turtle. Most often a slip. Grammars that draw nothing, or that have contexts, are left in peace.
Errors find_idle(const Grammar& grammar);

/// Errors of a derivation; those that name no place are given that of the grammar.
Errors placed(Errors errors, const GrammarText& text);

}  // namespace frond
