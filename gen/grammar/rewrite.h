#pragma once

#include <array>
#include <cmath>

#include "grammar/grammar.h"

namespace frond {

/// The rule that rewrites a module: the first that matches or, where that one carries a weight, one drawn
/// from all that match and carry one. `match(rule, index)` tells whether contexts and limits allow a rule and
/// sets `at.frame`. Index into the set, or -1 where the module stays as it is.
template <class Match>
int choose(const RuleSet& set, SymbolId symbol, Evaluation& at, const Match& match) {
  auto applies = [&](int index) {
    const Production& rule = set.rules[static_cast<std::size_t>(index)];
    if (!match(rule, index)) return false;
    if (!rule.conditional) return true;
    double truth = evaluate(rule.condition, at);
    at.fault |= std::isnan(truth);
    return truth != 0;
  };
  const auto& of = set.of[symbol];
  for (std::size_t i = 0; i < of.size(); ++i) {
    if (!applies(of[i])) continue;
    if (!set.rules[of[i]].weighted) return of[i];
    double total = 0;
    std::array<double, 64> sums;  // more rules than this for one symbol do not draw
    std::size_t last = std::min(of.size(), i + sums.size());
    for (std::size_t j = i; j < last; ++j) {
      bool drawn = set.rules[of[j]].weighted && (j == i || applies(of[j]));
      double weight = drawn ? (match(set.rules[of[j]], of[j]), evaluate(set.rules[of[j]].weight, at)) : 0.0;
      at.fault |= !(weight >= 0);
      sums[j - i] = total += weight;
    }
    double drawn = at.seed.unit() * total;
    for (std::size_t j = i; j < last; ++j) {
      if (drawn >= sums[j - i]) continue;
      match(set.rules[of[j]], of[j]);
      return of[j];
    }
    return -1;
  }
  return -1;
}

/// Most parameters that a module may have.
inline constexpr int kMostParameters = 32;

/// Rewrites a module depth first with context-free rules, the outcome of a rule again, up to `depth` levels.
/// Every module that is left goes to `emit(symbol, parameters)`, which stops the whole by false. Nothing is
/// stored but the path.
template <class Emit>
bool expand(const Grammar& grammar, const RuleSet& set, SymbolId symbol, const double* parameters, int depth,
            Evaluation at, Emit& emit) {
  int index = -1;
  if (depth > 0 && !set.of[symbol].empty()) {
    index = choose(set, symbol, at, [&](const Production&, int) { return at.frame = parameters, true; });
  }
  if (index < 0) return emit(symbol, parameters);
  const Production& rule = set.rules[static_cast<std::size_t>(index)];
  const Expression* argument = rule.arguments.data();
  std::array<double, kMostParameters> values;
  Evaluation below = at;
  std::uint64_t child = 0;
  for (SymbolId next : rule.successor) {
    for (int i = 0, n = grammar.symbols[next].arity; i < n; ++i) {
      values[static_cast<std::size_t>(i)] = evaluate(*argument++, at);
    }
    below.seed = at.seed.child(child++ + 0x10000);
    below.fault = at.fault;
    if (!expand(grammar, set, next, values.data(), depth - 1, below, emit)) return false;
  }
  return true;
}

}  // namespace frond
