#pragma once

#include "core/result.h"
#include "grammar/grammar.h"
#include "organisms/grower.h"

namespace frond {

/// Errors of compile() with the property that each is about as a JSON pointer below the organism:
/// "/grammar/rules/2", "/grammar/axiom", or "/grammar" where it does not say.
Errors pointed(const GrammarText& grammar, Errors errors);

/// Why a derivation is sure not to come to its end. What is only extrapolated is tried when it grows.
Errors size_faults(const Grammar& grammar);

/// What a grammar's word and skeleton will be, with `smoothing` nodes for each segment.
Result<SizeEstimate> estimate_word(const Result<Grammar>& grammar, Seed seed, int smoothing);

}  // namespace frond
