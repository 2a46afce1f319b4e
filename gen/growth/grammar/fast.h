#pragma once

#include <optional>

#include "grammar/derive.h"

namespace frond {

/// Whether each symbol has at most one rule, nothing has parameters, and nothing happens between steps: then
/// steps are composed in advance and several are made at once.
bool is_fixed(const Grammar& grammar);

/// Makes `steps` steps of a fixed grammar.
Errors advance_fixed(const Grammar& grammar, Derivation& state, int steps, const Limits& limits);

/// Whether each step rewrites one module, from left to right, and earlier modules stay unchanged.
bool is_leftmost(const Grammar& grammar);

/// Makes `steps` steps of such a grammar, each in constant time whatever the length of the word.
Errors advance_leftmost(const Grammar& grammar, Derivation& state, int steps, Seed seed,
                        const Limits& limits);

/// One step of a grammar without contexts whose rules always apply, alone or by weight: modules are rewritten
/// independently, so chunks of the word are counted and then written in parallel. The same word as the
/// general algorithm. Nothing if the grammar is not of this kind or a number is not finite; the general
/// algorithm then finds the error.
std::optional<Errors> step_free(const Grammar& grammar, const Derivation& state, Word& out, Seed seed,
                                const Limits& limits);

/// One step of a grammar whose rules see at most one neighbour on each side and need no numbers: choices are
/// looked up in a table of neighbours. Nothing if the grammar is not of this kind.
class NeighbourTable {
 public:
  explicit NeighbourTable(const Grammar& grammar);

  bool fits() const { return !choice_.empty(); }
  Errors step(const Word& in, Word& out, const Limits& limits);

 private:
  void find_right(const Word& in);

  const Grammar& grammar_;
  std::size_t size_ = 0;              ///< number of symbols, plus one for no neighbour
  std::vector<std::int16_t> choice_;  ///< rule by left neighbour, symbol and right neighbour; -1: none
  Buffer<SymbolId> right_;
  std::vector<SymbolId> stack_;
};

/// The neighbours of each module of a word as contexts see them, skipping ignored symbols: on the left the
/// next module toward the root, on the right the next one on the module's own axis.
struct Neighbours {
  static constexpr std::uint32_t kNone = 0xffffffffu;

  Buffer<std::uint32_t> left, right;  ///< index of the neighbour, or kNone
  Buffer<std::uint32_t> parameters;   ///< first parameter of each module; empty without parameters

  /// Finds them for a word; buffers are reused.
  void find(const Grammar& grammar, const Word& word);
};

/// Whether the contexts of a rule match at `place`. If its contexts have parameters, `frame` receives all
/// variables of the rule.
bool match_contexts(const Grammar& grammar, const Word& word, const Neighbours& near, const Production& rule,
                    std::uint32_t place, std::vector<double>& frame);

/// One step of any grammar, module by module: contexts, conditions, weights, limited use. Long words are
/// rewritten in parallel chunks. With `leftmost` only the first module that has a rule is rewritten.
/// `parents`, if given, receives the position that each new module comes from.
Errors step_generally(const Grammar& grammar, Derivation& state, Word& out, Seed seed, const Limits& limits,
                      bool leftmost, std::vector<std::uint32_t>* parents = nullptr);

}  // namespace frond
