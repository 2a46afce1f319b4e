#pragma once

#include "core/result.h"
#include "grammar/grammar.h"
#include "organisms/grower.h"

namespace frond {

/// Errors of compile() with a JSON pointer below the organism to the property concerned: "/grammar/rules/2",
/// "/grammar/axiom", or "/grammar" if unknown.
Errors pointed(const GrammarText& grammar, Errors errors);

/// The reason why a derivation certainly cannot finish. Extrapolated predictions do not count; the derivation
/// is then tried.
Errors size_faults(const Grammar& grammar);

/// Predicted size of a grammar's word and skeleton, with `smoothing` nodes per segment.
Result<SizeEstimate> estimate_word(const Result<Grammar>& grammar, Seed seed, int smoothing);

}  // namespace frond
