#pragma once

#include "grammar/grammar.h"

namespace frond {

/// Rules that an earlier one always takes the place of. They do nothing, and nothing is wrong without them: notes.
void find_shadowed(const RuleSet& set, Errors& notes);

/// Decomposition rules that may never end: for any random choice and any condition, their results are
/// decomposed again. Names one of them.
Errors find_endless(const Grammar& grammar);

/// Symbols that are produced but never used: no rule rewrites them, and they mean nothing to the turtle. Most
/// often a typing mistake. Grammars that draw nothing, or have contexts, are not checked.
Errors find_idle(const Grammar& grammar);

/// Errors of a derivation; those without a place get that of the grammar.
Errors placed(Errors errors, const GrammarText& text);

}  // namespace frond
