#pragma once

#include "grammar/grammar.h"

namespace frond {

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

}  // namespace frond
