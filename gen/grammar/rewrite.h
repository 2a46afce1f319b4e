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

/// What is said of a rule that divides by zero or makes a number that is not finite.
std::string fault_in(const Production& rule);

/// Most parameters that a module may have.
inline constexpr int kMostParameters = 32;

/// Rewrites modules depth first with context-free rules, the outcome of a rule again. Only the path to the
/// module at hand is kept, on the heap, and without what has no other successor to come back to.
class Expander {
 public:
  /// Why an expansion stopped before its end.
  enum class Stop { none, size, fault, depth };

  /// With `most`, an expansion has to come to its end: a rule that would apply beyond the depth stops it, and
  /// so do more applications than that.
  Expander(const Grammar& grammar, const RuleSet& set, std::size_t most = 0)
      : grammar_(grammar), set_(set), most_(most) {}

  /// Applies rules up to `depth` levels. Every module that is left goes to `emit(symbol, parameters)`, which
  /// stops the whole by false; so does a number that is not finite. `at` tells the place: seed, step and
  /// tables.
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
        values_.erase(values_.begin() + static_cast<std::ptrdiff_t>(level.frame),
                      values_.begin() + static_cast<std::ptrdiff_t>(frame));
        frame = level.frame;
        path_.pop_back();
      }
    }
  }

  /// After run() gave false: why (`size`: emit() or `most` stopped it), and otherwise the rule at work.
  Stop stop() const { return stop_; }
  const Production& rule() const { return *rule_; }

 private:
  /// A rule whose successor is being gone through.
  struct Level {
    const Production* rule;
    const Expression* argument;  // of the next module
    std::size_t next;            // module of the successor
    std::size_t frame;           // where the parameters of its predecessor begin
    Seed seed;
    std::uint32_t draws, draws_below;
    int depth;
  };

  /// Rewrites a module whose parameters stand at `frame`, the last of all, or lets it go.
  template <class Emit>
  bool visit(SymbolId symbol, std::size_t frame, int depth, Evaluation& at, Emit& emit) {
    int index = -1;
    if ((depth > 0 || most_ > 0) && !set_.of[symbol].empty())
      index = choose(set_, symbol, at,
                     [&](const Production&, int) { return at.frame = values_.data() + frame, true; });
    if (at.fault) return halt(Stop::fault, &set_.rules[set_.of[symbol][0]]);
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
    for (std::size_t i = first; i < values_.size(); ++i) {
      values_[i] = evaluate(*level.argument++, at);
      at.fault |= !std::isfinite(values_[i]);
    }
    level.draws = at.draws;
    return at.fault ? halt(Stop::fault, level.rule) : true;
  }

  void leave() {
    values_.resize(path_.back().frame);
    path_.pop_back();
  }

  bool halt(Stop why, const Production* rule) {
    stop_ = why, rule_ = rule;
    return false;
  }

  const Grammar& grammar_;
  const RuleSet& set_;
  std::vector<Level> path_;
  std::vector<double> values_;
  std::size_t most_, applied_ = 0;
  Stop stop_ = Stop::none;
  const Production* rule_ = nullptr;
};

}  // namespace frond
