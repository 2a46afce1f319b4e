#include "grammar/review.h"

#include <fmt/format.h>

#include <algorithm>

namespace frond {

namespace {

using Marks = std::array<bool, 256>;

/// Whether a module of that symbol may be left as it is: no rule is sure to apply.
bool may_stay(const RuleSet& set, std::size_t symbol) {
  return std::ranges::none_of(set.of[symbol], [&](std::uint16_t index) {
    const Production& rule = set.rules[index];
    bool drawn = !rule.weighted || (rule.weight.form == Expression::Form::constant && rule.weight.value > 0);
    return !rule.conditional && drawn;
  });
}

/// Symbols that may be taken apart to an end: those that may stay, and those with a rule whose successor
/// holds such symbols only.
Marks ending(const Grammar& grammar) {
  Marks ends{};
  for (std::size_t i = 0; i < grammar.symbols.size(); ++i) ends[i] = may_stay(grammar.decomposition, i);
  for (bool progress = true; progress;) {
    progress = false;
    for (const Production& rule : grammar.decomposition.rules) {
      if (ends[rule.predecessor] ||
          !std::ranges::all_of(rule.successor, [&](SymbolId symbol) { return ends[symbol]; }))
        continue;
      ends[rule.predecessor] = progress = true;
    }
  }
  return ends;
}

/// Symbols that somebody looks for, by any number of parameters: in predecessors, contexts and the lists of
/// what contexts see, behind a `~` and among the organs.
bool is_known(const Grammar& grammar, const std::string& name) {
  auto named = [&](SymbolId symbol) { return grammar.symbols[symbol].name == name; };
  auto organ = [&](std::span<const SymbolId> word) {
    for (std::size_t i = 0; i + 1 < word.size(); ++i)
      if (grammar.symbols[word[i]].act == Act::organ && named(word[i + 1])) return true;
    return false;
  };
  for (const RuleSet* set : {&grammar.rules, &grammar.decomposition, &grammar.interpretation})
    for (const Production& rule : set->rules)
      if (named(rule.predecessor) || std::ranges::any_of(rule.left, named) ||
          std::ranges::any_of(rule.right, named) || organ(rule.successor))
        return true;
  const GrammarText& text = grammar.text;
  return organ(grammar.axiom.symbols) || std::ranges::find(text.organs, name) != text.organs.end() ||
         std::ranges::find(text.symbols, name) != text.symbols.end() ||
         (text.ignore + text.consider).find(name) != std::string::npos;
}

/// Whether the words that are rewritten have the symbol.
bool is_derived(const Grammar& grammar, std::size_t symbol) {
  auto in = [&](const auto& word) {
    return std::ranges::find(word, static_cast<SymbolId>(symbol)) != word.end();
  };
  auto makes = [&](const Production& rule) { return in(rule.successor); };
  return in(grammar.axiom.symbols) || std::ranges::any_of(grammar.rules.rules, makes) ||
         std::ranges::any_of(grammar.decomposition.rules, makes);
}

/// A name that is rewritten with one number of parameters and used with another.
std::optional<Error> other_arity(const Grammar& grammar, std::size_t symbol) {
  const Symbol& used = grammar.symbols[symbol];
  if (!is_derived(grammar, symbol)) return std::nullopt;
  for (std::size_t i = 0; i < grammar.symbols.size(); ++i)
    if (grammar.symbols[i].name == used.name && !grammar.rules.of[i].empty())
      return Error{grammar.rules.rules[grammar.rules.of[i][0]].where,
                   fmt::format("`{}` is rewritten with {} parameter(s) only; with {} it stays as it is",
                               used.name, grammar.symbols[i].arity, used.arity)};
  return std::nullopt;
}

}  // namespace

void find_shadowed(const RuleSet& set, Errors& notes) {
  for (const auto& of : set.of) {
    for (std::size_t later = 1; later < of.size(); ++later) {
      const Production& hidden = set.rules[of[later]];
      for (std::size_t earlier = 0; earlier < later; ++earlier) {
        const Production& first = set.rules[of[earlier]];
        bool wider = first.context_free() || (first.left == hidden.left && first.right == hidden.right);
        bool certain = !first.conditional && first.limit == GrammarText::kUnlimited &&
                       !(first.weighted && hidden.weighted);
        if (!wider || !certain) continue;
        notes.push_back(
            {hidden.where, fmt::format("`{}` can never be used: `{}` ({}) comes first and always matches; "
                                       "put it before, give both a weight, or remove it",
                                       hidden.text, first.text, first.where)});
        break;
      }
    }
  }
}

Errors find_endless(const Grammar& grammar) {
  Marks ends = ending(grammar);
  for (const Production& start : grammar.decomposition.rules) {
    if (ends[start.predecessor]) continue;
    // From one that never ends to the next, until one comes again.
    Marks passed{};
    SymbolId at = start.predecessor;
    const Production* rule = nullptr;
    while (!passed[at]) {
      passed[at] = true;
      rule = &grammar.decomposition.rules[grammar.decomposition.of[at][0]];
      at = *std::ranges::find_if(rule->successor, [&](SymbolId symbol) { return !ends[symbol]; });
    }
    return {
        {rule->where, fmt::format("`{}` never ends: what it makes is taken apart into `{}` again; give it "
                                  "a condition, or put it among `rules`",
                                  rule->text, grammar.symbols[at].name)}};
  }
  return {};
}

Errors find_idle(const Grammar& grammar) {
  Errors warnings = grammar.text.notes;
  if (grammar.text.mutations > 0)
    warnings.push_back({"mutate", "does nothing: only grammars of LParser are mutated"});
  // Words with contexts hold signals and states that mean something by their neighbours alone.
  bool draws = grammar.context_free && std::ranges::any_of(grammar.symbols, [](const Symbol& symbol) {
                 return draws_line(symbol.act);
               });
  for (std::size_t i = 0; i < grammar.symbols.size(); ++i) {
    const Symbol& symbol = grammar.symbols[i];
    const std::optional<Making>& made = grammar.making[i];
    if (!made || !grammar.rules.of[i].empty()) continue;
    if (std::optional<Error> other = other_arity(grammar, i)) {
      warnings.push_back(std::move(*other));
    } else if (draws && symbol.act == Act::none && made->where != "axiom" &&
               !is_known(grammar, symbol.name)) {
      warnings.push_back(
          {made->where, fmt::format("column {}: `{}` does nothing: no rule rewrites it and the "
                                    "turtle does not know it; in `{}`",
                                    made->at + 1, symbol.name, made->text)});
    }
  }
  return warnings;
}

Errors placed(Errors errors, const GrammarText& text) {
  for (Error& error : errors)
    if (error.where.empty()) error.where = text.where;
  return errors;
}

}  // namespace frond
