#include "grammar/derive.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/cancellation.h"
#include "core/lookalike.h"
#include "grammar/fast.h"
#include "grammar/forecast.h"
#include "grammar/rewrite.h"
#include "grammar/turtle.h"

namespace frond {

namespace {

/// Removes each `%` with the rest of its branch; `kept`, where given, receives the places of what is left.
void cut(const Grammar& grammar, Word& word, std::vector<std::uint32_t>* kept = nullptr) {
  std::size_t to = 0, parameters_to = 0, parameter = 0;
  int skipped = -1;  // brackets open since the cut; -1: nothing is cut
  for (std::size_t i = 0; i < word.size(); ++i) {
    SymbolId symbol = word.symbols[i];
    auto arity = static_cast<std::size_t>(grammar.symbols[symbol].arity);
    if (skipped >= 0 && symbol == grammar.close && skipped-- == 0)
      skipped = -1;
    else if (skipped >= 0 && symbol == grammar.open)
      ++skipped;
    else if (skipped < 0 && grammar.symbols[symbol].act == Act::cut)
      skipped = 0;
    if (skipped < 0) {
      word.symbols[to++] = symbol;
      if (kept) kept->push_back(static_cast<std::uint32_t>(i));
      for (std::size_t k = 0; k < arity; ++k)
        word.parameters[parameters_to++] = word.parameters[parameter + k];
    }
    parameter += arity;
  }
  word.symbols.resize(to);
  word.parameters.resize(parameters_to);
}

constexpr int kDeepest = 100'000;  // levels of decomposition: beyond them there is no end to be seen

/// Why a step's decomposition was given up.
Error trouble(const Expander& expander, int step, const Limits& limits) {
  if (expander.stop() == Expander::Stop::size)
    return error_at("",
                    "step {} passes the limit of {} modules and {} bytes by decomposition; use fewer steps, "
                    "or conditions that end sooner",
                    step, limits.modules, limits.bytes);
  const Production& rule = expander.rule();
  if (expander.stop() == Expander::Stop::depth)
    return error_at(rule.where,
                    "step {}: `{}` takes its own outcome apart again and again, still so after {} times; add "
                    "a condition that ends it",
                    step, rule.text, kDeepest);
  return error_at(rule.where, "step {}: {}", step, expander.fault());
}

/// Applies decomposition rules until none applies any more; `parents`, where given, follow.
Errors decompose(const Grammar& grammar, Derivation& state, Seed seed, const Limits& limits,
                 std::vector<std::uint32_t>* parents = nullptr) {
  std::vector<std::uint32_t> from;
  Word out;
  Evaluation at;
  at.tables = grammar.tables;
  at.step = state.steps + 1;
  // What is taken apart and erased takes time, too.
  Expander expander(grammar, grammar.decomposition, limits.modules + 1);
  auto emit = [&](SymbolId symbol, const double* parameters) {
    out.symbols.push_back(symbol);
    out.parameters.insert(out.parameters.end(), parameters, parameters + grammar.symbols[symbol].arity);
    return out.size() <= limits.modules && out.bytes() <= limits.bytes;
  };
  Seed place = seed.child("decompose", static_cast<std::uint64_t>(state.steps) + 1);
  const double* parameters = state.word.parameters.data();
  for (std::size_t i = 0; i < state.word.size(); ++i) {
    at.seed = place.child(i);
    if (!expander.run(state.word.symbols[i], parameters, kDeepest, at, emit))
      return {trouble(expander, state.steps + 1, limits)};
    parameters += grammar.symbols[state.word.symbols[i]].arity;
    if (parents) from.resize(out.size(), (*parents)[i]);
  }
  std::swap(state.word, out);
  if (parents) *parents = std::move(from);
  return {};
}

}  // namespace

std::string fault_in(std::string_view rule, const Evaluation& at) {
  constexpr std::string_view kFaults[] = {"", "division by zero", "the array has no element of that number",
                                          "a number that is not finite", "a weight below 0"};
  return fmt::format(
      "column {}: {} in `{}`; add a condition that keeps the rule away from there, as `q != 0 and …`",
      column_of(rule, at.fault_place), kFaults[static_cast<std::size_t>(at.fault)], rule);
}

Derivation begin(const Grammar& grammar, Seed seed) {
  Derivation state;
  state.word = grammar.axiom;
  if (grammar.limited) state.uses.resize(grammar.rules.rules.size());
  if (grammar.queries) answer_queries(grammar, state.word, seed, grammar.environment);
  return state;
}

namespace {

Errors advance_stepwise(const Grammar& grammar, Derivation& state, int steps, Seed seed, const Limits& limits,
                        bool plainly) {
  bool sequential = grammar.text.mode == GrammarText::Mode::sequential;
  std::optional<NeighbourTable> table;
  if (!plainly) table.emplace(grammar);
  Word next;
  for (int i = 0; i < steps; ++i) {
    stay_wanted();
    if (grammar.cuts) cut(grammar, state.word);
    std::optional<Errors> done;
    if (table && table->fits())
      done = table->step(state.word, next, limits);
    else if (!plainly && !sequential)
      done = step_free(grammar, state, next, seed, limits);
    Errors errors = done ? *done : step_generally(grammar, state, next, seed, limits, sequential);
    if (!errors.empty()) return errors;
    std::swap(state.word, next);
    if (!grammar.decomposition.empty()) errors = decompose(grammar, state, seed, limits);
    if (!errors.empty()) return errors;
    if (grammar.queries) answer_queries(grammar, state.word, seed, grammar.environment);
    ++state.steps;
    if (state.word.bytes() > limits.bytes)
      return {
          error_at("", "step {} passes the limit of {} bytes; use fewer steps", state.steps, limits.bytes)};
  }
  return {};
}

}  // namespace

Errors advance(const Grammar& grammar, Derivation& state, int steps, Seed seed, const Limits& limits) {
  if (is_fixed(grammar)) return advance_fixed(grammar, state, steps, limits);
  if (is_leftmost(grammar)) return advance_leftmost(grammar, state, steps, seed, limits);
  return advance_stepwise(grammar, state, steps, seed, limits, false);
}

Errors advance_plainly(const Grammar& grammar, Derivation& state, int steps, Seed seed,
                       const Limits& limits) {
  return advance_stepwise(grammar, state, steps, seed, limits, true);
}

Errors advance_tracked(const Grammar& grammar, Derivation& state, Seed seed,
                       std::vector<std::uint32_t>& parents, const Limits& limits) {
  std::vector<std::uint32_t> kept;
  Word next;
  parents.clear();
  if (grammar.cuts) cut(grammar, state.word, &kept);
  bool sequential = grammar.text.mode == GrammarText::Mode::sequential;
  Errors errors = step_generally(grammar, state, next, seed, limits, sequential, &parents);
  if (!errors.empty()) return errors;
  std::swap(state.word, next);
  if (!grammar.decomposition.empty()) errors = decompose(grammar, state, seed, limits, &parents);
  if (grammar.queries) answer_queries(grammar, state.word, seed, grammar.environment);
  if (grammar.cuts)
    std::transform(parents.begin(), parents.end(), parents.begin(), [&](std::uint32_t i) { return kept[i]; });
  ++state.steps;
  return errors;
}

Result<Word> derive(const Grammar& grammar, int steps, Seed seed, const Limits& limits) {
  if (steps < 0) return Error{"steps", "the number of steps must be 0 or more"};
  Errors errors;
  if (has_growth_matrix(grammar)) errors = refuse(forecast(grammar, steps, seed, limits), limits);
  if (!errors.empty()) return errors;
  Derivation state = begin(grammar, seed);
  errors = advance(grammar, state, steps, seed, limits);
  if (!errors.empty()) return errors;
  return std::move(state.word);
}

Word interpret(const Grammar& grammar, const Word& word, Seed seed) {
  Word out;
  Evaluation at;
  at.tables = grammar.tables;
  Expander expander(grammar, grammar.interpretation);
  auto emit = [&](SymbolId symbol, const double* parameters) {
    out.symbols.push_back(symbol);
    out.parameters.insert(out.parameters.end(), parameters, parameters + grammar.symbols[symbol].arity);
    return true;
  };
  Seed place = seed.child("interpret");
  const double* parameters = word.parameters.data();
  for (std::size_t i = 0; i < word.size(); ++i) {
    at.seed = place.child(i);
    expander.run(word.symbols[i], parameters, grammar.text.interpretation_depth, at, emit);
    parameters += grammar.symbols[word.symbols[i]].arity;
  }
  return out;
}

}  // namespace frond
