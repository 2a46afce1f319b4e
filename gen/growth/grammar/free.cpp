
#include <algorithm>
#include <cstring>

#include "core/parallel.h"
#include "grammar/fast.h"

namespace frond {

namespace {

constexpr std::size_t kFreeChunk = 1 << 15;
constexpr std::size_t kFreeBlock = 16;  // symbols copied at a time, whatever the length

/// A rule as the inner loop wants it.
struct Outcome {
  const SymbolId* symbols = nullptr;
  const Expression* arguments = nullptr;
  std::uint32_t length = 0, parameters = 0;
};

/// What may become of a symbol: it stays (no outcomes), one outcome, or one of several by lot.
struct Choice {
  const Outcome* outcomes = nullptr;
  const double* sums = nullptr;  // of the weights, where lots are drawn
  std::uint32_t count = 0;       // of outcomes
  double total = 0;
};

/// The rules of a grammar in this form.
class Table {
 public:
  explicit Table(const Grammar& grammar) {
    const RuleSet& set = grammar.rules;
    outcomes_.reserve(set.rules.size());
    sums_.reserve(set.rules.size());
    for (std::size_t symbol = 0; symbol < grammar.symbols.size() && fits_; ++symbol) {
      arity_[symbol] = static_cast<std::uint8_t>(grammar.symbols[symbol].arity);
      Choice& choice = choices_[symbol];
      choice.outcomes = outcomes_.data() + outcomes_.size();
      choice.sums = sums_.data() + sums_.size();
      for (std::uint16_t index : set.of[symbol]) add(set.rules[index], choice);
      bool lots = choice.count > 0 && set.rules[set.of[symbol][0]].weighted;
      fits_ &= !lots || choice.total > 0;
      if (!lots) choice.sums = nullptr;
    }
  }

  bool fits() const { return fits_; }
  const Choice& operator[](SymbolId symbol) const { return choices_[symbol]; }
  std::uint32_t arity(SymbolId symbol) const { return arity_[symbol]; }

 private:
  void add(const Production& rule, Choice& choice) {
    bool plain = rule.context_free() && !rule.conditional && rule.limit == GrammarText::kUnlimited;
    bool one = !rule.weighted && choice.count == 0;
    bool lot = rule.weighted && rule.weight.form == Expression::Form::constant && choice.count < 64 &&
               (choice.count == 0 || choice.total > 0);
    if (!plain || !(one || lot)) fits_ = false;
    choice.total += rule.weighted ? rule.weight.value : 0;
    ++choice.count;
    sums_.push_back(choice.total);
    // Behind each successor there is room to read a block too far.
    padded_.push_back(rule.successor);
    padded_.back().resize(rule.successor.size() + kFreeBlock);
    outcomes_.push_back({padded_.back().data(), rule.arguments.data(),
                         static_cast<std::uint32_t>(rule.successor.size()),
                         static_cast<std::uint32_t>(rule.arguments.size())});
  }

  std::array<Choice, 256> choices_{};
  std::array<std::uint8_t, 256> arity_{};
  std::vector<Outcome> outcomes_;
  std::vector<double> sums_;
  std::vector<std::vector<SymbolId>> padded_;
  bool fits_ = true;
};

/// The outcome at the place of index `i`; none where the module stays.
inline const Outcome* sample(const Choice& choice, Seed seed, std::size_t i) {
  if (choice.count == 0) return nullptr;
  if (!choice.sums) return choice.outcomes;
  double lot = seed.child(i).unit() * choice.total;
  std::size_t pick = 0;
  for (std::uint32_t k = 0; k + 1 < choice.count; ++k) pick += lot >= choice.sums[k];
  return choice.outcomes + pick;
}

/// Where a chunk begins, in the word before and in the word after.
struct Place {
  std::size_t parameters_in = 0, symbols_out = 0, parameters_out = 0;
};

struct FreeStep {
  const Grammar& grammar;
  const Table& table;
  const Word& in;
  Word& out;
  Seed seed;
  double number;

  Place count(std::size_t first, std::size_t last) const {
    Place sum;
    for (std::size_t i = first; i < last; ++i) {
      SymbolId symbol = in.symbols[i];
      const Outcome* outcome = sample(table[symbol], seed, i);
      sum.parameters_in += table.arity(symbol);
      sum.symbols_out += outcome ? outcome->length : 1;
      sum.parameters_out += outcome ? outcome->parameters : table.arity(symbol);
    }
    return sum;
  }

  /// False when a parameter is not finite.
  bool write(std::size_t first, std::size_t last, Place at, std::size_t symbols_end) const {
    const double* parameters = in.parameters.data() + at.parameters_in;
    SymbolId* symbols = out.symbols.data() + at.symbols_out;
    const SymbolId* end = out.symbols.data() + symbols_end;
    double* values = out.parameters.data() + at.parameters_out;
    Evaluation evaluation;
    evaluation.tables = grammar.tables;
    evaluation.step = number;
    double wrong = 0;  // not 0 as soon as something is not finite
    for (std::size_t i = first; i < last; ++i) {
      SymbolId symbol = in.symbols[i];
      const Outcome* outcome = sample(table[symbol], seed, i);
      std::uint32_t arity = table.arity(symbol);
      if (!outcome) {
        *symbols++ = symbol;
        for (std::uint32_t k = 0; k < arity; ++k) *values++ = parameters[k];
      } else {
        copy(symbols, end, *outcome);
        symbols += outcome->length;
        if (outcome->parameters > 0) {
          evaluation.frame = parameters;
          evaluation.seed = seed.child(i);
          evaluation.draws = 0;
          for (std::uint32_t k = 0; k < outcome->parameters; ++k) {
            double value = evaluate(outcome->arguments[k], evaluation);
            wrong += value - value;
            *values++ = value;
          }
        }
      }
      parameters += arity;
    }
    return wrong == 0 && !evaluation.failed();
  }

  static void copy(SymbolId* to, const SymbolId* end, const Outcome& outcome) {
    if (static_cast<std::size_t>(end - to) < outcome.length + kFreeBlock) {
      if (outcome.length > 0) std::memcpy(to, outcome.symbols, outcome.length);
      return;
    }
    std::memcpy(to, outcome.symbols, kFreeBlock);
    for (std::size_t k = kFreeBlock; k < outcome.length; k += kFreeBlock)
      std::memcpy(to + k, outcome.symbols + k, kFreeBlock);
  }
};

template <class T>
void make_room(Buffer<T>& buffer, std::size_t size) {
  buffer.clear();
  if (buffer.capacity() < size) Buffer<T>().swap(buffer);
  buffer.resize(size);
}

}  // namespace

std::optional<Errors> step_free(const Grammar& grammar, const Derivation& state, Word& out, Seed seed,
                                const Limits& limits) {
  if (!grammar.context_free || grammar.limited) return std::nullopt;
  Table table(grammar);
  if (!table.fits()) return std::nullopt;
  int number = state.steps + 1;
  FreeStep step{grammar, table, state.word, out, seed.child("step", number), static_cast<double>(number)};
  std::size_t size = state.word.size(), chunks = (size + kFreeChunk - 1) / kFreeChunk;
  std::vector<Place> places(chunks + 1);
  auto end_of = [&](std::size_t i) { return std::min(size, (i + 1) * kFreeChunk); };
  parallel_for(chunks, [&](std::size_t i) { places[i + 1] = step.count(i * kFreeChunk, end_of(i)); });
  for (std::size_t i = 0; i < chunks; ++i) {
    places[i + 1].parameters_in += places[i].parameters_in;
    places[i + 1].symbols_out += places[i].symbols_out;
    places[i + 1].parameters_out += places[i].parameters_out;
  }
  std::size_t modules = places[chunks].symbols_out,
              bytes = modules + places[chunks].parameters_out * sizeof(double);
  if (modules > limits.modules || bytes > limits.bytes)
    return Errors{error_at(
        "", "step {} has {} modules ({} bytes), past the limit of {} modules and {} bytes; use fewer steps",
        number, modules, bytes, limits.modules, limits.bytes)};
  make_room(out.symbols, modules);
  make_room(out.parameters, places[chunks].parameters_out);
  std::vector<char> good(chunks);
  parallel_for(chunks, [&](std::size_t i) {
    good[i] = step.write(i * kFreeChunk, end_of(i), places[i], places[i + 1].symbols_out);
  });
  if (std::find(good.begin(), good.end(), 0) != good.end()) return std::nullopt;
  return Errors{};
}

}  // namespace frond
