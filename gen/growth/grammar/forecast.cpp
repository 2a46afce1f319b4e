#include "grammar/forecast.h"

#include <algorithm>
#include <cmath>

#include "core/figures.h"
#include "grammar/stream.h"

namespace frond {

namespace {

constexpr double kEnough = 1e300;                     // of modules: no forecast goes on beyond it
constexpr double kSmallWord = 1e5, kSmallWork = 2e6;  // modules or segments; modules of all words
constexpr int kMostStreamed = 100;  // steps: a path so deep needs no more than 100 KB of the stack

/// What one module of a symbol becomes in a step: how many of each symbol, on average.
using Counts = std::vector<std::pair<SymbolId, double>>;

void add(Counts& row, SymbolId symbol, double count) {
  auto same = std::find_if(row.begin(), row.end(), [&](const auto& entry) { return entry.first == symbol; });
  if (same != row.end())
    same->second += count;
  else
    row.emplace_back(symbol, count);
}

void add_successor(Counts& row, const Production& rule, double share) {
  for (SymbolId symbol : rule.successor) add(row, symbol, share);
}

/// Whether all rules of a symbol are weighted by numbers and apply everywhere, or the first applies always.
bool has_row(const RuleSet& set, SymbolId symbol) {
  const auto& of = set.of[symbol];
  auto fixed = [&](std::uint16_t index) {
    const Production& rule = set.rules[index];
    return rule.context_free() && !rule.conditional && rule.limit == GrammarText::kUnlimited &&
           (!rule.weighted || rule.weight.form == Expression::Form::constant);
  };
  return std::all_of(of.begin(), of.end(), fixed);
}

Counts row_of(const RuleSet& set, SymbolId symbol) {
  Counts row;
  const auto& of = set.of[symbol];
  double total = 0;
  for (std::uint16_t index : of) total += set.rules[index].weighted ? set.rules[index].weight.value : 0;
  for (std::uint16_t index : of) {
    const Production& rule = set.rules[index];
    if (!rule.weighted) return add_successor(row, rule, 1), row;
    if (rule.weight.value > 0) add_successor(row, rule, rule.weight.value / total);
  }
  if (of.empty() || total <= 0) row.emplace_back(symbol, 1);
  return row;
}

/// What decomposition leaves of one module of each symbol: by rules that lead to an end whatever happens.
/// Nothing where there are others.
std::optional<std::vector<Counts>> decomposed(const Grammar& grammar) {
  const RuleSet& set = grammar.decomposition;
  std::vector<Counts> rows(grammar.symbols.size());
  std::vector<char> known(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!has_row(set, static_cast<SymbolId>(i))) return std::nullopt;
    if (!set.of[i].empty()) continue;
    rows[i].emplace_back(static_cast<SymbolId>(i), 1);
    known[i] = true;
  }
  for (bool progress = true; progress;) {
    progress = false;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (known[i]) continue;
      Counts once = row_of(set, static_cast<SymbolId>(i));
      if (!std::ranges::all_of(once, [&](const auto& entry) { return known[entry.first] != 0; })) continue;
      for (auto [symbol, count] : once)
        for (auto [last, times] : rows[symbol]) add(rows[i], last, count * times);
      known[i] = progress = true;
    }
  }
  if (std::ranges::find(known, 0) != known.end()) return std::nullopt;
  return rows;
}

/// How many turtles a guide may make of one.
double most_turtles(const Grammar& grammar) {
  return grammar.guide.points.empty() ? 1.0 : static_cast<double>(grammar.guide.leaves());
}

/// Segments that one module of each symbol draws, interpretation included; where turtles fork, at most.
std::vector<double> segments_of_symbols(const Grammar& grammar) {
  std::vector<double> plain(grammar.symbols.size());
  for (std::size_t i = 0; i < plain.size(); ++i)
    if (draws_line(grammar.symbols[i].act)) plain[i] = most_turtles(grammar);
  std::vector<double> now = plain;
  for (int depth = 0; depth < grammar.text.interpretation_depth && !grammar.interpretation.empty(); ++depth) {
    std::vector<double> next = plain;
    for (std::size_t i = 0; i < plain.size(); ++i) {
      if (grammar.interpretation.of[i].empty()) continue;
      next[i] = 0;
      for (auto [symbol, count] : row_of(grammar.interpretation, static_cast<SymbolId>(i)))
        next[i] += count * now[symbol];
    }
    now = next;
  }
  return now;
}

/// Size of a word known by how often each symbol occurs.
struct Sizes {
  double modules = 0, bytes = 0, segments = 0;
};

Sizes sizes_of(const Grammar& grammar, const std::vector<double>& times,
               const std::vector<double>& segments) {
  Sizes sizes;
  for (std::size_t i = 0; i < times.size(); ++i) {
    sizes.modules += times[i];
    sizes.bytes +=
        times[i] * (sizeof(SymbolId) + sizeof(double) * static_cast<double>(grammar.symbols[i].arity));
    sizes.segments += times[i] * segments[i];
  }
  return sizes;
}

std::vector<double> times_in(const Grammar& grammar, const Word& word) {
  std::vector<double> times(grammar.symbols.size());
  for (SymbolId symbol : word.symbols) times[symbol] += 1;
  return times;
}

/// Notes the word after a step, and with it those of the next `alike` steps, which are no other.
void note(Forecast& forecast, const Sizes& sizes, int step, const Limits& limits, int alike = 0) {
  double spare = kSmallWork - forecast.work - sizes.modules;
  if (std::max(sizes.modules, sizes.segments) <= kSmallWord && spare >= 0)
    forecast.small_steps =
        step + static_cast<int>(std::min<double>(alike, spare / std::max(1.0, sizes.modules)));
  forecast.work = std::min(forecast.work + (1.0 + alike) * sizes.modules, kEnough);
  forecast.modules = std::min(sizes.modules, kEnough);
  forecast.bytes = std::min(sizes.bytes, kEnough);
  forecast.segments = std::min(sizes.segments, kEnough);
  auto most = static_cast<double>(limits.modules);
  bool passes =
      sizes.modules > most || sizes.segments > most || sizes.bytes > static_cast<double>(limits.bytes);
  if (!passes || forecast.passes_at >= 0) return;
  forecast.passes_at = step;
  forecast.passes_with = std::max(forecast.modules, forecast.segments);
}

void by_matrix(const Grammar& grammar, int steps, const Limits& limits, Forecast& forecast) {
  const std::vector<Counts> parts = *decomposed(grammar);
  std::vector<Counts> rows(grammar.symbols.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (auto [symbol, count] : row_of(grammar.rules, static_cast<SymbolId>(i)))
      for (auto [last, times] : parts[symbol]) add(rows[i], last, count * times);
  for (const RuleSet* set : {&grammar.rules, &grammar.decomposition})
    for (const Production& rule : set->rules)
      if (rule.weighted) forecast.kind = Forecast::Kind::expected;
  std::vector<double> segments = segments_of_symbols(grammar), times = times_in(grammar, grammar.axiom);
  note(forecast, sizes_of(grammar, times, segments), 0, limits);
  for (int step = 1; step <= steps; ++step) {
    std::vector<double> next(times.size());
    for (std::size_t i = 0; i < times.size(); ++i)
      if (times[i] > 0)
        for (auto [symbol, count] : rows[i]) next[symbol] += times[i] * count;
    bool same = next == times;
    times = std::move(next);
    note(forecast, sizes_of(grammar, times, segments), step, limits, same ? steps - step : 0);
    if (same) break;
    if (forecast.modules >= kEnough) break;
  }
}

/// Grows the word a little and goes on at the rate of its last steps.
void by_dry_run(const Grammar& grammar, int steps, Seed seed, const Limits& limits, Forecast& forecast) {
  std::vector<double> segments = segments_of_symbols(grammar);
  Derivation state = begin(grammar, seed);
  Limits small{std::min<std::size_t>(limits.modules, 2'000'000),
               std::min<std::size_t>(limits.bytes, 64u << 20)};
  Sizes now = sizes_of(grammar, times_in(grammar, state.word), segments), before = now, earlier = now;
  note(forecast, now, 0, limits);
  double largest = 1;  // module, in bytes
  for (const Symbol& symbol : grammar.symbols)
    largest = std::max(largest, sizeof(SymbolId) + sizeof(double) * static_cast<double>(symbol.arity));
  int step = 0;
  std::size_t work = 0;
  while (step < steps && now.modules < 1e6 && work < 4'000'000) {
    Errors errors = advance(grammar, state, 1, seed, small);
    if (!errors.empty() && !errors[0].where.empty()) return forecast.trouble = std::move(errors), void();
    ++step;
    if (!errors.empty()) {  // more than the dry run may have
      forecast.kind = Forecast::Kind::at_least;
      earlier = now;
      now.modules =
          1 + std::min(static_cast<double>(small.modules), static_cast<double>(small.bytes) / largest);
      now.bytes = std::max(now.bytes, now.modules);
      note(forecast, now, step, limits);
      break;
    }
    work += state.word.size() + 1;
    earlier = before, before = now;
    now = sizes_of(grammar, times_in(grammar, state.word), segments);
    note(forecast, now, step, limits);
  }
  if (step == steps) return;
  forecast.kind = Forecast::Kind::extrapolated;
  // Two steps back, as many grammars grow in one step and rest in the next.
  double rate = std::sqrt(std::max(1.0, now.modules / std::max(1.0, earlier.modules)));
  double added = std::max(0.0, (now.modules - earlier.modules) / 2);
  bool linear = rate < 1.01;
  for (; step < steps; ++step) {
    double factor = linear ? (now.modules + added) / std::max(1.0, now.modules) : rate;
    now = {now.modules * factor, now.bytes * factor, now.segments * factor};
    note(forecast, now, step + 1, limits);
    if (now.modules >= kEnough) return;
  }
}

}  // namespace

bool can_stream(const Grammar& grammar, int steps) {
  return grammar.context_free && !grammar.limited && !grammar.cuts && !grammar.queries &&
         grammar.decomposition.empty() && grammar.text.mode == GrammarText::Mode::parallel &&
         steps <= kMostStreamed;
}

bool has_growth_matrix(const Grammar& grammar) {
  if (grammar.text.mode == GrammarText::Mode::sequential || grammar.cuts || !decomposed(grammar))
    return false;
  for (std::size_t i = 0; i < grammar.symbols.size(); ++i)
    if (!has_row(grammar.rules, static_cast<SymbolId>(i))) return false;
  return true;
}

Forecast forecast(const Grammar& grammar, int steps, Seed seed, const Limits& limits) {
  Forecast forecast;
  if (has_growth_matrix(grammar))
    by_matrix(grammar, steps, limits, forecast);
  else
    by_dry_run(grammar, steps, seed, limits, forecast);
  if (most_turtles(grammar) > 1) forecast.kind = Forecast::Kind::extrapolated;
  return forecast;
}

Errors refuse(const Forecast& forecast, const Limits& limits) {
  if (!forecast.trouble.empty()) return forecast.trouble;
  if (forecast.passes_at < 0) return {};
  std::string_view how = forecast.kind == Forecast::Kind::exact      ? "would have"
                         : forecast.kind == Forecast::Kind::expected ? "would have on average"
                         : forecast.kind == Forecast::Kind::at_least ? "would have at least"
                                                                     : "would have about";
  return {error_at("",
                   "step {} {} {} modules or segments, past the limit of {} modules and {} bytes; the last "
                   "step {} {} ({}): use at most {} steps, or raise `limits`",
                   forecast.passes_at, how, count_text(forecast.passes_with), limits.modules, limits.bytes,
                   how, count_text(forecast.modules), bytes_text(forecast.bytes),
                   std::max(0, forecast.passes_at - 1))};
}

}  // namespace frond
