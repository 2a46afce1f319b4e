#pragma once

#include "grammar/grammar.h"

namespace frond {

/// A mistake in a rule, at an offset in its text.
Error in_rule(const Production& rule, std::size_t place, std::string_view what);

/// Characters in axiom, rules and constants that look like signs of ASCII and are not: the first of each
/// text, with the sign that is meant. Those that `symbols` names are symbols.
void find_odd_signs(const GrammarText& text, Errors& errors);

/// Interpretation rules that make more modules of one than can be walked: interpretation happens while the
/// turtle walks, where nothing else would stop a word without end.
void find_swelling(const Grammar& grammar, Errors& errors);

/// Notes rules that an earlier one always takes the place of. They do nothing, and nothing is wrong.
void find_shadowed(const RuleSet& set, Errors& notes);

/// Decomposition rules that may never end: for any random choice and any condition, their results are
/// decomposed again. Names one of them.
Errors find_endless(const Grammar& grammar);

/// Warns of symbols that are produced but never used: no rule rewrites them, and they mean nothing to the
/// turtle. Most often a typing mistake. Grammars that draw nothing, or have contexts, are checked for letters
/// of other alphabets and for numbers of parameters only.
Errors review_warnings(const Grammar& grammar);

/// Errors of a derivation; those without a place get that of the grammar.
Errors placed(Errors errors, const GrammarText& text);

}  // namespace frond
