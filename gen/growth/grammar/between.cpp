#include "grammar/between.h"

namespace frond {

namespace {

/// Where the parameters of each module begin, and of one behind the last.
std::vector<std::size_t> offsets_of(const Grammar& grammar, const Word& word) {
  std::vector<std::size_t> offsets{0};
  for (SymbolId symbol : word.symbols)
    offsets.push_back(offsets.back() + static_cast<std::size_t>(grammar.symbols[symbol].arity));
  return offsets;
}

/// How far a module takes the turtle, branches left out; `depth` is that of the branch it is in.
double reach_of(const Grammar& grammar, Expander& expander, SymbolId symbol, const double* parameters,
                int& depth) {
  double reach = 0;
  auto emit = [&](SymbolId id, const double* values) {
    const Symbol& info = grammar.symbols[id];
    if (info.act == Act::push) ++depth;
    if (info.act == Act::pop) --depth;
    if (goes_forward(info.act) && depth == 0)
      reach += std::abs(way_of(info, values, grammar.text.length, grammar.text.dialect));
    return true;
  };
  Evaluation at;
  at.tables = grammar.tables;
  expander.run(symbol, parameters, grammar.text.interpretation_depth, at, emit);
  return reach;
}

/// One parent and the run of modules that it became.
struct Family {
  const Grammar& grammar;
  Expander& expander;
  const Word& before;
  Word& after;
  const std::vector<std::size_t>& before_at;
  const std::vector<std::size_t>& after_at;
  double age;

  /// A module that became one of its own kind goes on: its parameters are on their way to what they will be.
  bool goes_on(std::size_t parent, std::size_t first, std::size_t last) {
    if (last - first != 1 || before.symbols[parent] != after.symbols[first]) return false;
    const double* was = before.parameters.data() + before_at[parent];
    for (std::size_t i = after_at[first]; i < after_at[last]; ++i, ++was)
      after.parameters[i] = *was + age * (after.parameters[i] - *was);
    return true;
  }

  void grow(std::size_t parent, std::size_t first, std::size_t last, std::vector<Unfolding>& growth) {
    if (goes_on(parent, first, last)) return;
    int depth = 0;
    double was = reach_of(grammar, expander, before.symbols[parent],
                          before.parameters.data() + before_at[parent], depth),
           is = 0;
    for (std::size_t i = first; i < last; ++i) {
      bool bracket = after.symbols[i] == grammar.open || after.symbols[i] == grammar.close;
      if (depth == 0 || bracket)
        is += reach_of(grammar, expander, after.symbols[i], after.parameters.data() + after_at[i], depth);
    }
    double axis = is > 0 ? age + (1 - age) * was / is : age;
    const Symbol& old = grammar.symbols[before.symbols[parent]];
    for (std::size_t i = first; i < last; ++i) {
      const Symbol& now = grammar.symbols[after.symbols[i]];
      depth += after.symbols[i] == grammar.open ? 1 : after.symbols[i] == grammar.close ? -1 : 0;
      growth[i] = {age, depth == 0 ? axis : age, 0, false};
      if (last - first == 1 && now.act == old.act && now.arity > 0 && old.arity > 0) {
        growth[i].from = before.parameters[before_at[parent]];
        growth[i].has_from = true;
      }
    }
  }
};

/// Names the modules of a word: one that goes on in its own kind keeps its name, others get new ones.
std::vector<std::uint64_t> named(const Word& before, const std::vector<std::uint64_t>& names,
                                 const Word& after, const std::vector<std::uint32_t>& parents) {
  std::vector<std::uint64_t> result(after.size());
  for (std::size_t first = 0, last = 0; first < parents.size(); first = last) {
    std::uint64_t parent = names[parents[first]];
    while (last < parents.size() && parents[last] == parents[first]) ++last;
    bool same = last - first == 1 && before.symbols[parents[first]] == after.symbols[first];
    for (std::size_t i = first; i < last; ++i) result[i] = same ? parent : Seed{parent}.child(i - first).key;
  }
  return result;
}

}  // namespace

Result<Between> between(const Grammar& grammar, double steps, Seed seed, const Limits& limits, bool names) {
  if (!(steps >= 0)) return Error{"steps", "the number of steps must be 0 or more"};
  int whole = static_cast<int>(std::ceil(steps)) - 1;  // the steps that are over
  Errors errors;
  if (has_growth_matrix(grammar)) errors = refuse(forecast(grammar, whole + 1, seed, limits), limits);
  if (!errors.empty()) return errors;
  Derivation state = begin(grammar, seed);
  Between result;
  for (std::size_t i = 0; names && i < state.word.size(); ++i) result.name.push_back(Seed{}.child(i).key);
  if (!names) errors = advance(grammar, state, whole, seed, limits);
  Word before = state.word;
  std::vector<std::uint32_t> parents;
  for (int step = names ? 0 : whole; step <= whole && errors.empty(); ++step) {
    before = state.word;
    errors = advance_tracked(grammar, state, seed, parents, limits);
    if (names && errors.empty()) result.name = named(before, result.name, state.word, parents);
  }
  if (!errors.empty()) return errors;
  result.word = std::move(state.word);
  result.growth.resize(result.word.size());
  if (whole < 0) return result;
  std::vector<std::size_t> before_at = offsets_of(grammar, before),
                           after_at = offsets_of(grammar, result.word);
  Expander expander(grammar, grammar.interpretation);
  Family family{
      grammar, expander, before, result.word, before_at, after_at, smooth_step(0.0, 1.0, steps - whole)};
  for (std::size_t first = 0, last = 0; first < parents.size(); first = last) {
    while (last < parents.size() && parents[last] == parents[first]) ++last;
    family.grow(parents[first], first, last, result.growth);
  }
  return result;
}

}  // namespace frond
