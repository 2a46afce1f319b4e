
#include <algorithm>

#include "grammar/fast.h"

namespace frond {

namespace {

constexpr std::uint32_t kNone = Neighbours::kNone;

/// The last module that contexts see on the outermost level, from the given end: where a ring closes.
template <bool kFromRight>
std::uint32_t outermost(const Grammar& grammar, const Word& word) {
  int depth = 0;
  std::size_t n = word.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t i = kFromRight ? n - 1 - k : k;
    SymbolId symbol = word.symbols[i];
    if (symbol == grammar.open)
      ++depth;
    else if (symbol == grammar.close)
      --depth;
    else if (depth == 0 && grammar.symbols[symbol].context)
      return static_cast<std::uint32_t>(i);
  }
  return kNone;
}

/// Matches a right context, entering the branches that it names and passing over the others.
struct RightMatcher {
  const Grammar& grammar;
  const Word& word;
  const Neighbours& near;
  const std::vector<SymbolId>& pattern;
  std::vector<std::uint32_t> found;  // where each module of the pattern was found
  std::vector<std::uint32_t> outer;  // branches entered: the bracket that opens each

  /// The closing bracket that belongs to the opening one.
  std::uint32_t closing(std::uint32_t open) const {
    int depth = 0;
    for (std::uint32_t i = open;; ++i) {
      if (word.symbols[i] == grammar.open) ++depth;
      if (word.symbols[i] == grammar.close && --depth == 0) return i;
    }
  }

  /// The first module on the axis that goes on behind `place`.
  std::uint32_t ahead(std::uint32_t place) const {
    SymbolId symbol = word.symbols[place];
    return symbol == grammar.open || symbol == grammar.close ? first_from(place + 1) : near.right[place];
  }

  std::uint32_t first_from(std::uint32_t place) const {
    if (place >= word.size() || word.symbols[place] == grammar.close) return kNone;
    return grammar.symbols[word.symbols[place]].context ? place : near.right[place];
  }

  /// Whether the pattern from `k` on fits behind `place`.
  bool match(std::size_t k, std::uint32_t place) {
    if (k == pattern.size()) return true;
    if (pattern[k] == grammar.open) return match_branch(k, place);
    if (pattern[k] == grammar.close) {
      std::uint32_t open = outer.back();
      outer.pop_back();
      bool fits = match(k + 1, closing(open));
      outer.push_back(open);
      return fits;
    }
    std::uint32_t next = ahead(place);
    if (next == kNone || word.symbols[next] != pattern[k]) return false;
    found.push_back(next);
    if (match(k + 1, next)) return true;
    found.pop_back();
    return false;
  }

  bool match_branch(std::size_t k, std::uint32_t place) {
    for (std::uint32_t i = place + 1; i < word.size(); ++i) {
      SymbolId symbol = word.symbols[i];
      if (symbol == grammar.close || grammar.symbols[symbol].context) return false;
      if (symbol != grammar.open) continue;
      outer.push_back(i);
      bool fits = match(k + 1, i);
      outer.pop_back();
      if (fits) return true;
      i = closing(i);
    }
    return false;
  }
};

bool match_left(const Word& word, const Neighbours& near, const Production& rule, std::uint32_t place) {
  for (std::size_t k = rule.left.size(); k-- > 0;) {
    place = near.left[place];
    if (place == kNone || word.symbols[place] != rule.left[k]) return false;
  }
  return true;
}

void add_parameters(const Grammar& grammar, const Word& word, const Neighbours& near, std::uint32_t place,
                    std::vector<double>& frame) {
  int arity = grammar.symbols[word.symbols[place]].arity;
  if (arity == 0) return;
  const double* first = word.parameters.data() + near.parameters[place];
  frame.insert(frame.end(), first, first + arity);
}

void add_left_parameters(const Grammar& grammar, const Word& word, const Neighbours& near,
                         const Production& rule, std::uint32_t place, std::vector<double>& frame) {
  std::vector<std::uint32_t> places;
  for (std::size_t k = rule.left.size(); k-- > 0;) places.push_back(place = near.left[place]);
  for (std::size_t k = places.size(); k-- > 0;) add_parameters(grammar, word, near, places[k], frame);
}

}  // namespace

void Neighbours::find(const Grammar& grammar, const Word& word) {
  std::size_t n = word.size();
  left.resize(n), right.resize(n);
  std::vector<std::uint32_t> stack;
  std::uint32_t now = grammar.text.ring ? outermost<false>(grammar, word) : kNone;
  for (std::size_t i = n; i-- > 0;) {
    SymbolId symbol = word.symbols[i];
    if (symbol == grammar.close) {
      stack.push_back(now);
      right[i] = now = kNone;
      continue;
    }
    if (symbol == grammar.open) now = stack.back(), stack.pop_back();
    right[i] = now;
    if (grammar.symbols[symbol].context) now = static_cast<std::uint32_t>(i);
  }
  now = grammar.text.ring ? outermost<true>(grammar, word) : kNone;
  for (std::size_t i = 0; i < n; ++i) {
    SymbolId symbol = word.symbols[i];
    left[i] = now;
    if (symbol == grammar.open) stack.push_back(now);
    if (symbol == grammar.close) now = stack.back(), stack.pop_back();
    if (grammar.symbols[symbol].context) now = static_cast<std::uint32_t>(i);
  }
  if (!grammar.parametric) return;
  parameters.resize(n);
  std::uint32_t at = 0;
  for (std::size_t i = 0; i < n; ++i) {
    parameters[i] = at;
    at += static_cast<std::uint32_t>(grammar.symbols[word.symbols[i]].arity);
  }
}

bool match_contexts(const Grammar& grammar, const Word& word, const Neighbours& near, const Production& rule,
                    std::uint32_t place, std::vector<double>& frame) {
  if (!match_left(word, near, rule, place)) return false;
  bool plain = std::find(rule.right.begin(), rule.right.end(), grammar.open) == rule.right.end();
  RightMatcher right{grammar, word, near, rule.right, {}, {}};
  if (plain) {
    std::uint32_t next = place;
    for (SymbolId symbol : rule.right) {
      next = near.right[next];
      if (next == kNone || word.symbols[next] != symbol) return false;
      if (rule.variables > 0) right.found.push_back(next);
    }
  } else if (!right.match(0, place)) {
    return false;
  }
  if (rule.variables == 0) return true;
  frame.clear();
  add_left_parameters(grammar, word, near, rule, place, frame);
  add_parameters(grammar, word, near, place, frame);
  for (std::uint32_t at : right.found) add_parameters(grammar, word, near, at, frame);
  return true;
}

NeighbourTable::NeighbourTable(const Grammar& grammar)
    : grammar_(grammar), size_(grammar.symbols.size() + 1) {
  if (grammar.context_free || grammar.parametric || grammar.limited || grammar.stochastic ||
      grammar.text.ring || size_ > 48)
    return;
  if (grammar.text.mode == GrammarText::Mode::sequential) return;
  for (const Production& rule : grammar.rules.rules) {
    bool bracket = std::find(rule.right.begin(), rule.right.end(), grammar.open) != rule.right.end();
    if (rule.left.size() > 1 || rule.right.size() > 1 || bracket || rule.conditional) return;
  }
  choice_.assign(size_ * size_ * size_, -1);
  for (std::size_t left = 0; left < size_; ++left) {
    for (std::size_t symbol = 0; symbol + 1 < size_; ++symbol) {
      for (std::size_t right = 0; right < size_; ++right) {
        for (std::uint16_t index : grammar.rules.of[symbol]) {
          const Production& rule = grammar.rules.rules[index];
          if ((!rule.left.empty() && rule.left[0] != left) || (!rule.right.empty() && rule.right[0] != right))
            continue;
          choice_[(left * size_ + symbol) * size_ + right] = static_cast<std::int16_t>(index);
          break;
        }
      }
    }
  }
}

/// The symbol of the right neighbour of each module, from the end to the start.
void NeighbourTable::find_right(const Word& in) {
  auto none = static_cast<SymbolId>(size_ - 1);
  SymbolId now = none;
  right_.resize(in.size());
  stack_.clear();
  for (std::size_t i = in.size(); i-- > 0;) {
    SymbolId symbol = in.symbols[i];
    if (symbol == grammar_.close) {
      stack_.push_back(now);
      now = none;
    } else if (symbol == grammar_.open) {
      now = stack_.back();
      stack_.pop_back();
    }
    right_[i] = now;
    now = grammar_.symbols[symbol].context ? symbol : now;
  }
}

Errors NeighbourTable::step(const Word& in, Word& out, const Limits& limits) {
  find_right(in);
  std::size_t longest = 1;
  std::array<bool, 256> seen{};
  for (std::size_t i = 0; i < grammar_.symbols.size(); ++i) seen[i] = grammar_.symbols[i].context;
  for (const Production& rule : grammar_.rules.rules) longest = std::max(longest, rule.successor.size());
  out.clear();
  if (out.symbols.capacity() < in.size() * 2) out.symbols.reserve(in.size() * 2);
  out.symbols.resize(out.symbols.capacity());
  SymbolId* to = out.symbols.data();
  SymbolId* end = to + out.symbols.size();
  auto left = static_cast<SymbolId>(size_ - 1);
  stack_.clear();
  for (std::size_t i = 0; i < in.size(); ++i) {
    SymbolId symbol = in.symbols[i];
    int index = choice_[(left * size_ + symbol) * size_ + right_[i]];
    if (end - to < static_cast<std::ptrdiff_t>(longest)) {
      std::size_t done = static_cast<std::size_t>(to - out.symbols.data());
      if (done > limits.modules) break;
      out.symbols.resize(out.symbols.size() * 2 + longest);
      to = out.symbols.data() + done;
      end = out.symbols.data() + out.symbols.size();
    }
    if (index < 0) {
      *to++ = symbol;
    } else {
      const auto& successor = grammar_.rules.rules[static_cast<std::size_t>(index)].successor;
      for (SymbolId next : successor) *to++ = next;
    }
    if (symbol == grammar_.open)
      stack_.push_back(left);
    else if (symbol == grammar_.close)
      left = stack_.back(), stack_.pop_back();
    else if (seen[symbol])
      left = symbol;
  }
  out.symbols.resize(static_cast<std::size_t>(to - out.symbols.data()));
  if (out.size() > limits.modules)
    return {error_at("", "the word passes the limit of {} modules; use fewer steps", limits.modules)};
  return {};
}

}  // namespace frond
