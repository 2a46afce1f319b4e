#pragma once

#include <span>

#include "grammar/grammar.h"

namespace frond {

/// A derivation between two steps: all that the next step depends on.
struct Derivation {
  Word word;
  int steps = 0;          ///< made so far
  std::vector<int> uses;  ///< of each rule, where the grammar has rules of limited use
};

/// The derivation before its first step: the axiom, its questions answered.
Derivation begin(const Grammar& grammar, Seed seed);

/// Makes so many steps more. Random choices depend on the seed, the number of the step and the place in the
/// word, and so neither on threads nor on how the steps are shared among calls. Empty when all went well;
/// otherwise what stopped it (a number that is not finite, a word past the limits), and the word is of no
/// use. Only an error about the limits has no place.
Errors advance(const Grammar& grammar, Derivation& derivation, int steps, Seed seed,
               const Limits& limits = {});

/// The same by the general way alone, module by module: slow, and what the faster ways are held to.
Errors advance_plainly(const Grammar& grammar, Derivation& derivation, int steps, Seed seed,
                       const Limits& limits = {});

/// Makes one step and tells for each module of the new word which of the old it came from.
Errors advance_tracked(const Grammar& grammar, Derivation& derivation, Seed seed,
                       std::vector<std::uint32_t>& parents, const Limits& limits = {});

/// The word after so many steps from the axiom.
Result<Word> derive(const Grammar& grammar, int steps, Seed seed, const Limits& limits = {});

/// The word as the turtle sees it: interpretation rules applied as deep as the grammar says.
Word interpret(const Grammar& grammar, const Word& word, Seed seed);

}  // namespace frond
