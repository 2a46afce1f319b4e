#include "grammar/review.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/lookalike.h"

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

/// A name that is rewritten with other numbers of parameters than it is used with.
std::optional<Error> other_arity(const Grammar& grammar, std::size_t symbol, const Making& made) {
  const Symbol& used = grammar.symbols[symbol];
  if (!is_derived(grammar, symbol)) return std::nullopt;
  std::string others;
  for (std::size_t i = 0; i < grammar.symbols.size(); ++i) {
    if (grammar.symbols[i].name != used.name || grammar.rules.of[i].empty()) continue;
    std::size_t rule = grammar.rules.of[i][0];
    others +=
        fmt::format("{}with {} (rule {}, column {})", others.empty() ? "" : " or ", grammar.symbols[i].arity,
                    rule + 1, column_of(grammar.rules.rules[rule].text, grammar.rules.rules[rule].place));
  }
  if (others.empty()) return std::nullopt;
  return error_at(
      made.where,
      "column {}: `{}` has {} parameters here and is rewritten {} only, so it stays as it is; in `{}`",
      column_of(made.text, made.at), used.name, used.arity, others, made.text);
}

/// A letter of another alphabet that looks like one that rules rewrite or the turtle knows.
std::optional<Error> twin_letter(const Grammar& grammar, const Symbol& symbol, const Making& made) {
  char latin = latin_lookalike(symbol.name);
  std::string name(1, latin);
  auto meant = [&](const Symbol& other) { return other.name == name; };
  if (latin == '\0' ||
      (act_of(name, grammar.text.dialect) == Act::none && std::ranges::none_of(grammar.symbols, meant)))
    return std::nullopt;
  return error_at(made.where,
                  "column {}: `{}` is a letter of another alphabet that looks like `{}`, and nothing "
                  "rewrites it; in `{}`",
                  column_of(made.text, made.at), symbol.name, name, made.text);
}

/// That nothing of the axiom is ever rewritten, though there are rules and steps.
std::optional<Error> unused_axiom(const Grammar& grammar) {
  auto changes = [&](SymbolId symbol) {
    return std::ranges::any_of(grammar.symbols, [&](const Symbol& other) {
      auto id = static_cast<std::size_t>(&other - grammar.symbols.data());
      return other.name == grammar.symbols[symbol].name &&
             !(grammar.rules.of[id].empty() && grammar.decomposition.of[id].empty());
    });
  };
  if (grammar.text.steps == 0 || grammar.rules.empty() || !grammar.interpretation.empty() ||
      grammar.axiom.symbols.empty() || std::ranges::any_of(grammar.axiom.symbols, changes))
    return std::nullopt;
  return error_at("axiom", "column 1: no rule rewrites anything of `{}`, so it stays as it is",
                  grammar.text.axiom);
}

}  // namespace

Error in_rule(const Production& rule, std::size_t place, std::string_view what) {
  return error_at(rule.where, "column {}: {}", column_of(rule.text, place), what);
}

void find_odd_signs(const GrammarText& text, Errors& errors) {
  auto is_symbol = [&](std::string_view sign) {
    return std::ranges::any_of(text.symbols, [&](const std::string& s) { return s.find(sign) != s.npos; });
  };
  auto report_odd_sign = [&](std::string_view where, std::string_view line) {
    std::optional<Lookalike> odd = find_lookalike(line);
    while (odd && is_symbol(line.substr(odd->at, odd->size))) odd = find_lookalike(line, odd->at + odd->size);
    if (!odd) return;
    errors.push_back(error_at(std::string(where),
                              "column {}: {} is not {}, which is meant; write that, or name it in `symbols` "
                              "where it is a symbol of its own; in `{}`",
                              column_of(line, odd->at), odd->name, odd->meant, line));
  };
  report_odd_sign("axiom", text.axiom);
  auto report_odd_signs = [&](const std::vector<GrammarText::Rule>& rules, std::string_view kind) {
    for (std::size_t i = 0; i < rules.size(); ++i)
      report_odd_sign(rules[i].where.empty() ? fmt::format("{} {}", kind, i + 1) : rules[i].where,
                      rules[i].text);
  };
  report_odd_signs(text.rules, "rule");
  report_odd_signs(text.decomposition, "decomposition rule");
  report_odd_signs(text.interpretation, "interpretation rule");
  for (const auto& [name, formula] : text.constants)
    report_odd_sign(fmt::format("constant `{}`", name), formula);
  report_odd_sign("ignore", text.ignore);
  report_odd_sign("consider", text.consider);
}

void find_swelling(const Grammar& grammar, Errors& errors) {
  constexpr double kMost = 1e7;
  std::vector<double> size(grammar.symbols.size(), 1);
  for (int depth = 0; depth < grammar.text.interpretation_depth; ++depth) {
    std::vector<double> next(size.size(), 1);
    for (const Production& rule : grammar.interpretation.rules) {
      double sum = 0;
      for (SymbolId symbol : rule.successor) sum += size[symbol];
      next[rule.predecessor] = std::max(next[rule.predecessor], sum);
      if (sum <= kMost) continue;
      return errors.push_back(
          in_rule(rule, rule.place,
                  fmt::format("`{}` makes {:.3g} modules of one at depth {}; lower `interpretation_depth`",
                              rule.text, sum, depth + 1)));
    }
    size = std::move(next);
  }
}

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
        notes.push_back(in_rule(hidden, hidden.place,
                                fmt::format("`{}` can never be used: `{}` ({}) comes first and always "
                                            "matches; put it before, give both a weight, or remove it",
                                            hidden.text, first.text, first.where)));
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
    return {in_rule(*rule, rule->place,
                    fmt::format("`{}` never ends: what it makes is taken apart into `{}` again; give it "
                                "a condition, or put it among `rules`",
                                rule->text, grammar.symbols[at].name))};
  }
  return {};
}

Errors review_warnings(const Grammar& grammar) {
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
    if (std::optional<Error> other = other_arity(grammar, i, *made)) {
      warnings.push_back(std::move(*other));
    } else if (std::optional<Error> twin = twin_letter(grammar, symbol, *made);
               twin && !is_known(grammar, symbol.name)) {
      warnings.push_back(std::move(*twin));
    } else if (draws && symbol.act == Act::none && made->where != "axiom" &&
               !is_known(grammar, symbol.name)) {
      warnings.push_back(error_at(
          made->where,
          "column {}: `{}` does nothing: no rule rewrites it and the turtle does not know it; in `{}`",
          column_of(made->text, made->at), symbol.name, made->text));
    }
  }
  if (std::optional<Error> unused = unused_axiom(grammar)) warnings.push_back(std::move(*unused));
  return warnings;
}

Errors placed(Errors errors, const GrammarText& text) {
  for (Error& error : errors)
    if (error.where.empty()) error.where = text.where;
  return errors;
}

}  // namespace frond
