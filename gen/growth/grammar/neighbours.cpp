#include <fmt/format.h>

#include <algorithm>

#include "grammar/fast.h"

namespace frond {

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
    return {{"", fmt::format("the word passes the limit of {} modules; use fewer steps", limits.modules)}};
  return {};
}

}  // namespace frond
