#pragma once

#include "grammar/grammar.h"

namespace frond {

/// For each module of a word who is next to it, as contexts see it: past what they look past, on the path to
/// the root on the left, on the module's own axis on the right.
struct Neighbours {
  static constexpr std::uint32_t kNone = 0xffffffffu;

  Buffer<std::uint32_t> left, right;  ///< index of the neighbour, or kNone
  Buffer<std::uint32_t> parameters;   ///< where the parameters of each module begin; empty without parameters

  /// Finds them for the word; the buffers are used again.
  void find(const Grammar& grammar, const Word& word);
};

/// Whether the contexts of a rule fit the module at `place`. Where the rule has parameters in its contexts,
/// `frame` receives all of its variables.
bool match_contexts(const Grammar& grammar, const Word& word, const Neighbours& near, const Production& rule,
                    std::uint32_t place, std::vector<double>& frame);

}  // namespace frond
