
#include <algorithm>

#include "grammar/fast.h"
#include "grammar/rewrite.h"

namespace frond {

namespace {

bool asks_step(const Expression& formula) {
  return std::any_of(formula.code.begin(), formula.code.end(), [](const Instruction& i) {
    return i.op == Op::step_number || i.op == Op::rand || i.op == Op::nrand;
  });
}

/// The word around the place that is rewritten: what lies left of it has no rule any more, what lies right of
/// it is kept from its end to its start, so that both are changed at their ends only.
class LeftmostRewriter {
 public:
  LeftmostRewriter(const Grammar& grammar, Derivation& state, Seed seed)
      : grammar_(grammar), state_(state), seed_(seed) {
    at_.tables = grammar.tables;
    std::reverse_copy(state.word.symbols.begin(), state.word.symbols.end(),
                      std::back_inserter(right_.symbols));
    std::reverse_copy(state.word.parameters.begin(), state.word.parameters.end(),
                      std::back_inserter(right_.parameters));
    state.word.clear();
  }

  /// Rewrites the leftmost module that has a rule. False when something is wrong.
  bool step() {
    at_.step = state_.steps + 1;
    Seed seed = seed_.child("step", static_cast<std::uint64_t>(state_.steps) + 1);
    for (; !right_.symbols.empty(); keep()) {
      SymbolId symbol = right_.symbols.back();
      if (grammar_.rules.of[symbol].empty()) continue;
      auto arity = static_cast<std::size_t>(grammar_.symbols[symbol].arity);
      frame_.assign(right_.parameters.rbegin(), right_.parameters.rbegin() + arity);
      at_.seed = seed.child(state_.word.size());
      at_.draws = 0;
      at_.frame = frame_.data();
      int index = choose(grammar_.rules, symbol, at_, [&](const Production& rule, int i) {
        return !grammar_.limited || state_.uses[static_cast<std::size_t>(i)] < rule.limit;
      });
      if (at_.failed()) return false;
      if (index >= 0) return write(static_cast<std::size_t>(index), arity);
    }
    return true;
  }

  std::size_t size() const { return state_.word.size() + right_.size(); }
  std::size_t bytes() const { return state_.word.bytes() + right_.bytes(); }

  /// Puts the word together again.
  void finish() {
    state_.word.symbols.insert(state_.word.symbols.end(), right_.symbols.rbegin(), right_.symbols.rend());
    state_.word.parameters.insert(state_.word.parameters.end(), right_.parameters.rbegin(),
                                  right_.parameters.rend());
  }

 private:
  void keep() {
    SymbolId symbol = right_.symbols.back();
    right_.symbols.pop_back();
    state_.word.symbols.push_back(symbol);
    for (int i = 0; i < grammar_.symbols[symbol].arity; ++i) {
      state_.word.parameters.push_back(right_.parameters.back());
      right_.parameters.pop_back();
    }
  }

  bool write(std::size_t index, std::size_t arity) {
    const Production& rule = grammar_.rules.rules[index];
    if (grammar_.limited) ++state_.uses[index];
    values_.clear();
    for (const Expression& argument : rule.arguments) values_.push_back(finite_value(argument, at_));
    if (at_.failed()) return false;
    right_.symbols.pop_back();
    right_.parameters.resize(right_.parameters.size() - arity);
    right_.symbols.insert(right_.symbols.end(), rule.successor.rbegin(), rule.successor.rend());
    right_.parameters.insert(right_.parameters.end(), values_.rbegin(), values_.rend());
    return true;
  }

  const Grammar& grammar_;
  Derivation& state_;
  Seed seed_;
  Evaluation at_;
  Word right_;
  std::vector<double> frame_, values_;
};

}  // namespace

bool is_leftmost(const Grammar& grammar) {
  if (grammar.text.mode != GrammarText::Mode::sequential || !grammar.context_free || grammar.cuts ||
      grammar.queries || !grammar.decomposition.empty())
    return false;
  // A module that has no rule now must have none later.
  return std::none_of(grammar.rules.rules.begin(), grammar.rules.rules.end(), [](const Production& rule) {
    return asks_step(rule.condition) ||
           (rule.weighted && !(rule.weight.form == Expression::Form::constant && rule.weight.value > 0));
  });
}

Errors advance_leftmost(const Grammar& grammar, Derivation& state, int steps, Seed seed,
                        const Limits& limits) {
  Derivation before = state;
  LeftmostRewriter cursor(grammar, state, seed);
  for (int i = 0; i < steps; ++i) {
    if (!cursor.step()) {
      // The general algorithm makes the same steps and finds the message for the error.
      state = std::move(before);
      return advance_plainly(grammar, state, steps, seed, limits);
    }
    ++state.steps;
    if (cursor.size() > limits.modules || cursor.bytes() > limits.bytes)
      return {error_at("", "step {} passes the limit of {} modules and {} bytes; use fewer steps",
                       state.steps, limits.modules, limits.bytes)};
  }
  cursor.finish();
  return {};
}

}  // namespace frond
