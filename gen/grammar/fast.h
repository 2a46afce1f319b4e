#pragma once

#include <optional>

#include "grammar/derive.h"

namespace frond {

/// Whether all rules are single, without parameters, and nothing happens between steps: then steps are
/// composed beforehand and made several at a time.
bool is_fixed(const Grammar& grammar);

/// Makes so many steps of a fixed grammar.
Errors advance_fixed(const Grammar& grammar, Derivation& state, int steps, const Limits& limits);

/// Whether words are rewritten one module a step from the left and what has been passed over stays so.
bool is_leftmost(const Grammar& grammar);

/// Makes so many steps of such a grammar, each in time that does not depend on the length of the word.
Errors advance_leftmost(const Grammar& grammar, Derivation& state, int steps, Seed seed,
                        const Limits& limits);

/// One step of a grammar without contexts whose rules apply always, alone or by lot: the outcome of a module
/// needs no look at others, so that chunks of the word are counted and then written side by side. The same
/// word as the general way makes. Nothing where the grammar is not of this kind, or where a number is not
/// finite: then the general way finds out which.
std::optional<Errors> step_free(const Grammar& grammar, const Derivation& state, Word& out, Seed seed,
                                const Limits& limits);

/// One step of a grammar whose rules look at no more than one neighbour a side and need no numbers: choices
/// are looked up in a table of neighbours. Nothing where the grammar is not of this kind.
class NeighbourTable {
 public:
  explicit NeighbourTable(const Grammar& grammar);

  bool fits() const { return !choice_.empty(); }
  Errors step(const Word& in, Word& out, const Limits& limits);

 private:
  void find_right(const Word& in);

  const Grammar& grammar_;
  std::size_t size_ = 0;              ///< symbols, and one more for no neighbour
  std::vector<std::int16_t> choice_;  ///< rule for left neighbour, symbol, right neighbour; -1: none
  Buffer<SymbolId> right_;
  std::vector<SymbolId> stack_;
};

/// One step of any grammar, module by module: contexts, conditions, lots, limited use. Long words are
/// rewritten in chunks side by side and put together. With `leftmost` only the first module that has a rule
/// is rewritten. `parents`, where given, receives the place each module of the outcome comes from.
Errors step_generally(const Grammar& grammar, Derivation& state, Word& out, Seed seed, const Limits& limits,
                      bool leftmost, std::vector<std::uint32_t>* parents = nullptr);

}  // namespace frond
