#pragma once

#include "grammar/derive.h"

namespace frond {

/// One step of any grammar, module by module: contexts, conditions, lots, limited use. Long words are
/// rewritten in chunks side by side and put together. With `leftmost` only the first module that has a rule
/// is rewritten. `parents`, where given, receives the place each module of the outcome comes from.
Errors step_generally(const Grammar& grammar, Derivation& state, Word& out, Seed seed, const Limits& limits,
                      bool leftmost, std::vector<std::uint32_t>* parents = nullptr);

}  // namespace frond
