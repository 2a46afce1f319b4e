#pragma once

#include "grammar/grammar.h"

namespace frond {

/// A grammar of LParser whose rules are mutated `mutations` times by its seed. Others stay as they are.
GrammarText mutated(GrammarText text);

/// The grammar as LParser carries it out, whose rules rewrite letters and know nothing of parameters: a
/// parameter stays behind what its letter becomes, so that `A -> FB` makes FB(20) of A(20). Mutated
/// before. Grammars of other dialects stay as they are.
GrammarText lparser_rules(GrammarText text);

/// compile() without what only grammars of LParser need.
Result<Grammar> compile_plainly(GrammarText text);

}  // namespace frond
