#pragma once

#include "grammar/grammar.h"

namespace frond {

/// A derivation between two steps: everything that the next step depends on.
struct Derivation {
  Word word;
  int steps = 0;          ///< made so far
  std::vector<int> uses;  ///< of each rule, where the grammar has rules of limited use
};

/// The derivation before its first step: the axiom with its questions answered.
Derivation begin(const Grammar& grammar, Seed seed);

/// Makes `steps` more steps. Random choices depend on the seed, the step number and the position in the word,
/// not on threads or on how steps are split among calls. Empty on success; otherwise the reason for stopping
/// (a number that is not finite, a word past the limits), and the word must not be used. Only an error about
/// the limits has no place.
Errors advance(const Grammar& grammar, Derivation& derivation, int steps, Seed seed,
               const Limits& limits = {});

/// Makes `steps` more steps as advance() does, but by the general algorithm alone, module by module: slow,
/// the reference for tests of the faster algorithms.
Errors advance_plainly(const Grammar& grammar, Derivation& derivation, int steps, Seed seed,
                       const Limits& limits = {});

/// Makes one step and returns for each module of the new word its origin in the old one.
Errors advance_tracked(const Grammar& grammar, Derivation& derivation, Seed seed,
                       std::vector<std::uint32_t>& parents, const Limits& limits = {});

/// The word after that number of steps from the axiom.
Result<Word> derive(const Grammar& grammar, int steps, Seed seed, const Limits& limits = {});

/// The word as the turtle sees it: interpretation rules applied to the depth set in the grammar.
Word interpret(const Grammar& grammar, const Word& word, Seed seed);

}  // namespace frond
