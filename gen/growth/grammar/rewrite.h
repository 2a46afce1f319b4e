#pragma once

#include <array>
#include <cmath>

#include "grammar/grammar.h"

namespace frond {

/// The rule that rewrites a module: the first that matches or, if that one has a weight, one drawn from all
/// matching rules with weights. `match(rule, index)` tells whether contexts and limits allow a rule and sets
/// `at.frame`. Returns the index in the set, or -1 if the module stays. Where a condition or a weight has no
/// value, `at.fault` says why, and the index is that of its rule.
template <class Match>
int choose(const RuleSet& set, SymbolId symbol, Evaluation& at, const Match& match) {
  auto applies = [&](int index) {
    const Production& rule = set.rules[static_cast<std::size_t>(index)];
    if (!match(rule, index)) return false;
    if (!rule.conditional) return true;
    double truth = evaluate(rule.condition, at);
    if (std::isnan(truth)) at.fail(FormulaFault::not_finite, rule.condition.place);
    return truth != 0;
  };
  const auto& of = set.of[symbol];
  for (std::size_t i = 0; i < of.size(); ++i) {
    bool first = applies(of[i]);
    if (at.failed()) return of[i];
    if (!first) continue;
    if (!set.rules[of[i]].weighted) return of[i];
    double total = 0;
    std::array<double, 64> sums;  // further weighted rules of one symbol are ignored
    std::size_t last = std::min(of.size(), i + sums.size());
    for (std::size_t j = i; j < last; ++j) {
      bool drawn = set.rules[of[j]].weighted && (j == i || applies(of[j]));
      double weight = drawn ? (match(set.rules[of[j]], of[j]), evaluate(set.rules[of[j]].weight, at)) : 0.0;
      if (!(weight >= 0)) at.fail(FormulaFault::bad_weight, set.rules[of[j]].weight.place);
      if (at.failed()) return of[j];
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

/// The message for a rule that divides by zero or produces a number that is not finite: with the column.
std::string fault_in(std::string_view rule, const Evaluation& at);

/// Maximum number of parameters of a module.
inline constexpr int kMostParameters = 32;

/// Rewrites modules recursively, depth first, with context-free rules. Only the path to the current module is
/// stored, on the heap, without levels whose last successor is being processed.
class Expander {
 public:
  /// Why an expansion stopped early.
  enum class Stop { none, size, fault, depth };

  /// With `most`, an expansion must end by itself: a rule that would apply beyond the depth stops it, and so
  /// do more than `most` applications.
  Expander(const Grammar& grammar, const RuleSet& set, std::size_t most = 0)
      : grammar_(grammar), set_(set), most_(most) {}

  /// Applies rules up to `depth` levels. Every final module goes to `emit(symbol, parameters)`, which stops
  /// the expansion by returning false, as a number that is not finite does. `at` holds seed, step and tables.
  template <class Emit>
  bool run(SymbolId symbol, const double* parameters, int depth, Evaluation at, Emit& emit) {
    if (set_.of[symbol].empty() || (depth <= 0 && most_ == 0))
      return emit(symbol, parameters) || halt(Stop::size, nullptr);
    path_.clear();
    values_.assign(parameters, parameters + grammar_.symbols[symbol].arity);
    for (std::size_t frame = 0;;) {
      if (!visit(symbol, frame, depth, at, emit)) return false;
      while (!path_.empty() && path_.back().next == path_.back().rule->successor.size()) leave();
      if (path_.empty()) return true;
      Level& level = path_.back();
      symbol = level.rule->successor[level.next++];
      frame = values_.size();
      if (!evaluate_arguments(level, symbol, at)) return false;
      at.seed = level.seed.child(level.next - 1 + 0x10000);
      at.draws = level.draws_below;
      depth = level.depth - 1;
      if (level.next == level.rule->successor.size()) {  // the last one takes the place of its parent
        values_.erase(values_.begin() + level.frame, values_.begin() + frame);
        frame = level.frame;
        path_.pop_back();
      }
    }
  }

  /// Why run() returned false (`size`: emit() or `most` stopped it), and for other reasons the rule involved.
  Stop stop() const { return stop_; }
  const Production& rule() const { return *rule_; }
  /// The message for a fault of rule(), after run() stopped with Stop::fault.
  std::string fault() const { return fault_in(rule_->text, fault_); }

 private:
  /// A rule whose successor is being processed.
  struct Level {
    const Production* rule;
    const Expression* argument;  // of the next module
    std::size_t next;            // index of the next module in the successor
    std::size_t frame;           // where the parameters of its predecessor begin
    Seed seed;
    std::uint32_t draws, draws_below;
    int depth;
  };

  /// Rewrites or emits the module whose parameters start at `frame`, at the end of the values.
  template <class Emit>
  bool visit(SymbolId symbol, std::size_t frame, int depth, Evaluation& at, Emit& emit) {
    int index = -1;
    if ((depth > 0 || most_ > 0) && !set_.of[symbol].empty())
      index = choose(set_, symbol, at,
                     [&](const Production&, int) { return at.frame = values_.data() + frame, true; });
    if (at.failed()) return halt_at(at, set_.rules[static_cast<std::size_t>(index)]);
    if (index < 0) {
      if (!emit(symbol, values_.data() + frame)) return halt(Stop::size, nullptr);
      values_.resize(frame);
      return true;
    }
    const Production* rule = &set_.rules[static_cast<std::size_t>(index)];
    if (depth <= 0) return halt(Stop::depth, rule);
    if (++applied_ == most_) return halt(Stop::size, nullptr);
    path_.push_back({rule, rule->arguments.data(), 0, frame, at.seed, at.draws, at.draws, depth});
    return true;
  }

  bool evaluate_arguments(Level& level, SymbolId symbol, Evaluation& at) {
    auto arity = static_cast<std::size_t>(grammar_.symbols[symbol].arity);
    if (arity == 0) return true;
    std::size_t first = values_.size();
    values_.resize(first + arity);
    at.frame = values_.data() + level.frame;
    at.seed = level.seed;
    at.draws = level.draws;
    for (std::size_t i = first; i < values_.size(); ++i) values_[i] = finite_value(*level.argument++, at);
    level.draws = at.draws;
    return at.failed() ? halt_at(at, *level.rule) : true;
  }

  void leave() {
    values_.resize(path_.back().frame);
    path_.pop_back();
  }

  bool halt(Stop why, const Production* rule) {
    stop_ = why, rule_ = rule;
    return false;
  }

  bool halt_at(const Evaluation& at, const Production& rule) {
    fault_ = at;
    return halt(Stop::fault, &rule);
  }

  const Grammar& grammar_;
  const RuleSet& set_;
  std::vector<Level> path_;
  std::vector<double> values_;
  std::size_t most_, applied_ = 0;
  Stop stop_ = Stop::none;
  const Production* rule_ = nullptr;
  Evaluation fault_;
};

}  // namespace frond
