
#include <algorithm>
#include <atomic>

#include "core/parallel.h"
#include "grammar/fast.h"
#include "grammar/rewrite.h"

namespace frond {

namespace {

constexpr std::size_t kModulesATask = 1 << 15;  // modules of the word that one task rewrites

/// A run of modules, and what becomes of it.
struct Chunk {
  std::size_t first = 0, last = 0, parameters = 0;
  Word out;
  Errors errors;
};

/// What all chunks of a step share.
struct GeneralStep {
  const Grammar& grammar;
  Derivation& state;
  const Neighbours& near;
  Seed seed;
  const Limits& limits;
  bool leftmost;
  std::vector<std::uint32_t>* parents;
};

/// Rewrites one chunk.
class Rewriter {
 public:
  explicit Rewriter(const GeneralStep& step) : step_(step), grammar_(step.grammar) {
    at_.tables = grammar_.tables;
    at_.step = step.state.steps + 1;
  }

  void run(Chunk& chunk) {
    const Word& in = step_.state.word;
    Word& out = chunk.out;
    out.clear();
    out.symbols.reserve((chunk.last - chunk.first) * 2);
    const double* parameters = in.parameters.data() + chunk.parameters;
    bool done = false;
    for (std::size_t i = chunk.first; i < chunk.last; ++i) {
      SymbolId symbol = in.symbols[i];
      int arity = grammar_.symbols[symbol].arity;
      int index = done ? -1 : find_rule(i, symbol, parameters);
      if (index < 0 || at_.failed()) {
        out.symbols.push_back(symbol);
        out.parameters.insert(out.parameters.end(), parameters, parameters + arity);
      } else {
        write(grammar_.rules.rules[static_cast<std::size_t>(index)], out);
        if (grammar_.limited) ++step_.state.uses[static_cast<std::size_t>(index)];
        done = step_.leftmost;
      }
      if (step_.parents) step_.parents->resize(out.size(), static_cast<std::uint32_t>(i));
      if (at_.failed()) chunk.errors = {trouble(i, symbol, parameters, index)};
      if (at_.failed() || out.size() > step_.limits.modules || out.bytes() > step_.limits.bytes) return;
      parameters += arity;
    }
  }

 private:
  int find_rule(std::size_t i, SymbolId symbol, const double* parameters) {
    if (grammar_.rules.of[symbol].empty()) return -1;
    at_.seed = step_.seed.child(i);
    at_.draws = 0;
    return choose(grammar_.rules, symbol, at_, [&](const Production& rule, int index) {
      if (grammar_.limited && step_.state.uses[static_cast<std::size_t>(index)] >= rule.limit) return false;
      at_.frame = parameters;
      if (rule.context_free()) return true;
      auto place = static_cast<std::uint32_t>(i);
      if (!match_contexts(grammar_, step_.state.word, step_.near, rule, place, frame_)) return false;
      if (rule.variables > 0) at_.frame = frame_.data();
      return true;
    });
  }

  void write(const Production& rule, Word& out) {
    out.symbols.insert(out.symbols.end(), rule.successor.begin(), rule.successor.end());
    for (const Expression& argument : rule.arguments) out.parameters.push_back(finite_value(argument, at_));
  }

  Error trouble(std::size_t i, SymbolId symbol, const double* parameters, int index) const {
    Word module;
    module.symbols.push_back(symbol);
    module.parameters.assign(parameters, parameters + grammar_.symbols[symbol].arity);
    const Production& rule = grammar_.rules.rules[static_cast<std::size_t>(index)];
    return error_at(rule.where, "step {}, module {} (`{}`): {}", step_.state.steps + 1, i + 1,
                    text(grammar_, module), fault_in(rule.text, at_));
  }

  const GeneralStep& step_;
  const Grammar& grammar_;
  Evaluation at_;
  std::vector<double> frame_;
};

/// The word cut into chunks; one where modules depend on what was done to those before.
std::vector<Chunk> chunks_of(const GeneralStep& step) {
  const Word& in = step.state.word;
  bool whole = step.grammar.limited || step.leftmost || step.parents || in.size() < 2 * kModulesATask;
  std::size_t size = whole ? std::max<std::size_t>(in.size(), 1) : kModulesATask;
  std::vector<Chunk> chunks((in.size() + size - 1) / size);
  std::size_t parameters = 0;
  for (std::size_t k = 0; k < chunks.size(); ++k) {
    chunks[k].first = k * size;
    chunks[k].last = std::min(in.size(), (k + 1) * size);
    chunks[k].parameters = parameters;
    if (!step.grammar.parametric || chunks.size() == 1) continue;
    for (std::size_t i = chunks[k].first; i < chunks[k].last; ++i)
      parameters += static_cast<std::size_t>(step.grammar.symbols[in.symbols[i]].arity);
  }
  return chunks;
}

/// Puts the outcomes together, each chunk freed as it is copied.
void join(std::vector<Chunk>& chunks, Word& out) {
  if (chunks.size() == 1) return std::swap(out, chunks[0].out);
  std::vector<std::pair<std::size_t, std::size_t>> begin{{0, 0}};
  for (const Chunk& chunk : chunks)
    begin.emplace_back(begin.back().first + chunk.out.symbols.size(),
                       begin.back().second + chunk.out.parameters.size());
  out.clear();
  out.symbols.resize(begin.back().first);
  out.parameters.resize(begin.back().second);
  parallel_for(chunks.size(), [&](std::size_t k) {
    Word& part = chunks[k].out;
    std::copy(part.symbols.begin(), part.symbols.end(), out.symbols.data() + begin[k].first);
    std::copy(part.parameters.begin(), part.parameters.end(), out.parameters.data() + begin[k].second);
    part = Word{};
  });
}

}  // namespace

Errors step_generally(const Grammar& grammar, Derivation& state, Word& out, Seed seed, const Limits& limits,
                      bool leftmost, std::vector<std::uint32_t>* parents) {
  Neighbours near;
  if (!grammar.context_free) near.find(grammar, state.word);
  auto number = static_cast<std::uint64_t>(state.steps) + 1;
  GeneralStep step{grammar, state, near, seed.child("step", number), limits, leftmost, parents};
  std::vector<Chunk> chunks = chunks_of(step);
  std::atomic<std::size_t> size{0}, bytes{0};
  auto too_large = [&] { return size > limits.modules || bytes > limits.bytes; };
  if (chunks.size() == 1) std::swap(chunks[0].out, out);  // its memory is used again
  parallel_for(chunks.size(), [&](std::size_t k) {
    if (too_large()) return;
    Rewriter(step).run(chunks[k]);
    size += chunks[k].out.size();
    bytes += chunks[k].out.bytes();
  });
  for (const Chunk& chunk : chunks)
    if (!chunk.errors.empty()) return chunk.errors;
  if (too_large())
    return {error_at("", "step {} passes the limit of {} modules and {} bytes; use fewer steps", number,
                     limits.modules, limits.bytes)};
  if (chunks.empty())
    out.clear();
  else
    join(chunks, out);
  return {};
}

}  // namespace frond
