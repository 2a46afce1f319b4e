#pragma once

#include "grammar/forecast.h"
#include "grammar/turtle.h"

namespace frond {

/// Whether a derivation can be sent to the turtle module by module without storing its words: rules without
/// contexts or limits, applied in parallel, and no cuts, questions or decomposition. Derivations of many
/// steps would need a deep call stack and are stored.
bool can_stream(const Grammar& grammar, int steps);

/// A derivation made depth first: the first module of the axiom is expanded completely before the second one.
/// Stores one module per step; gives the turtle the same modules as derive().
template <class Sink>
class Stream {
 public:
  Stream(const Grammar& grammar, int steps, Seed seed, Turtle<Sink>& turtle, const Limits& limits)
      : grammar_(grammar),
        turtle_(turtle),
        places_(static_cast<std::size_t>(steps)),
        left_(limits.modules),
        limit_(limits.modules) {
    for (int i = 1; i <= steps; ++i) seeds_.push_back(seed.child("step", static_cast<std::uint64_t>(i)));
  }

  /// Expands one module of the word after `level` steps to the last step. False if a number is not finite or
  /// there are more modules than the limit allows.
  bool grow(SymbolId symbol, const double* parameters, std::size_t level) {
    if (level < seeds_.size() && grammar_.rules.of[symbol].empty()) {
      if (grammar_.stochastic)
        for (std::size_t i = level; i < places_.size(); ++i) ++places_[i];
    } else if (level < seeds_.size()) {
      return rewrite(symbol, parameters, level);
    }
    turtle_.feed(symbol, parameters);
    if (left_-- > 0) return true;
    trouble_ = error_at("", "the word passes the limit of {} modules; use fewer steps", limit_);
    return false;
  }

  /// The error after grow() returned false.
  const Error& trouble() const { return trouble_; }

 private:
  bool rewrite(SymbolId symbol, const double* parameters, std::size_t level) {
    Evaluation at;
    at.tables = grammar_.tables;
    at.step = static_cast<double>(level) + 1;
    at.seed = seeds_[level].child(places_[level]++);
    int index = choose(grammar_.rules, symbol, at,
                       [&](const Production&, int) { return at.frame = parameters, true; });
    if (at.failed()) return fail(grammar_.rules.rules[static_cast<std::size_t>(index)], level, at);
    if (index < 0) return grow(symbol, parameters, level + 1);
    const Production& rule = grammar_.rules.rules[static_cast<std::size_t>(index)];
    const Expression* argument = rule.arguments.data();
    std::array<double, kMostParameters> values;
    for (SymbolId next : rule.successor) {
      for (int i = 0, n = grammar_.symbols[next].arity; i < n; ++i)
        values[static_cast<std::size_t>(i)] = finite_value(*argument++, at);
      if (at.failed()) return fail(rule, level, at);
      if (!grow(next, values.data(), level + 1)) return false;
    }
    return true;
  }

  bool fail(const Production& rule, std::size_t level, const Evaluation& at) {
    trouble_ = error_at(rule.where, "step {}: {}", level + 1, fault_in(rule.text, at));
    return false;
  }

  const Grammar& grammar_;
  Turtle<Sink>& turtle_;
  std::vector<Seed> seeds_;            // of each step
  std::vector<std::uint64_t> places_;  // number of modules so far of the word before each step
  std::size_t left_, limit_;           // number of modules still allowed, and allowed in all
  Error trouble_;
};

/// Derives and walks; streams if possible, otherwise stores the word. Returns the final state.
template <class Sink>
Result<TurtleState> draw(const Grammar& grammar, int steps, Seed seed, Sink& sink,
                         const Limits& limits = {}) {
  if (steps < 0 || !can_stream(grammar, steps)) {
    Result<Word> word = derive(grammar, steps, seed, limits);
    if (!word) return word.errors();
    Errors errors;
    TurtleState end = walk(grammar, *word, seed, sink, &errors);
    if (!errors.empty()) return errors;
    return end;
  }
  if (has_growth_matrix(grammar))
    if (Errors errors = refuse(forecast(grammar, steps, seed, limits), limits); !errors.empty())
      return errors;
  Turtle<Sink> turtle(grammar, seed, sink, start_of(grammar));
  Stream<Sink> stream(grammar, steps, seed, turtle, limits);
  const double* parameters = grammar.axiom.parameters.data();
  for (SymbolId symbol : grammar.axiom.symbols) {
    if (!stream.grow(symbol, parameters, 0)) return stream.trouble();
    parameters += grammar.symbols[symbol].arity;
  }
  if (Errors errors = turtle.trouble(); !errors.empty()) return errors;
  return turtle.finish();
}

}  // namespace frond
