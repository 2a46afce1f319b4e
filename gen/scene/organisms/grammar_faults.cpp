#include "organisms/grammar_faults.h"

#include <fmt/format.h>

#include <algorithm>

#include "grammar/review.h"
#include "preset/fault.h"

namespace frond {

namespace {

struct RuleList {
  std::string_view name;
  std::vector<GrammarText::Rule> GrammarText::*rules;
};

constexpr RuleList kRuleLists[] = {{"rules", &GrammarText::rules},
                                   {"decomposition", &GrammarText::decomposition},
                                   {"interpretation", &GrammarText::interpretation}};

/// What stands between the first backquotes of a text.
std::string_view in_backquotes(std::string_view text) {
  std::size_t begin = std::min(text.find('`'), text.size());
  text.remove_prefix(std::min(begin + 1, text.size()));
  return text.substr(0, text.find('`'));
}

/// Rules must have been placed.
std::string pointer_of(const GrammarText& grammar, const Error& error) {
  for (const RuleList& list : kRuleLists) {
    const std::vector<GrammarText::Rule>& rules = grammar.*list.rules;
    auto rule = std::ranges::find(rules, error.where, &GrammarText::Rule::where);
    if (rule != rules.end()) return fmt::format("/grammar/{}/{}", list.name, rule - rules.begin());
  }
  if (error.where.starts_with('/')) return error.where;
  if (error.where.starts_with("constant `"))
    return pointer_step("/grammar/constants", in_backquotes(error.where));
  if (!error.where.empty()) return pointer_step("/grammar", error.where);
  // A number that is out of range is named first of all.
  return error.what.starts_with('`') ? pointer_step("/grammar", in_backquotes(error.what)) : "/grammar";
}

}  // namespace

Errors pointed(const GrammarText& grammar, Errors errors) {
  for (Error& error : errors) error.where = pointer_of(grammar, error);
  return errors;
}

Errors size_faults(const Grammar& grammar) {
  const GrammarText& text = grammar.text;
  Forecast word = forecast(grammar, text.steps, Seed{1}, text.limits);
  bool guess = word.kind == Forecast::Kind::extrapolated && word.trouble.empty();
  return guess ? Errors{} : refuse(word, text.limits);
}

Result<SizeEstimate> estimate_word(const Result<Grammar>& grammar, Seed seed, int smoothing) {
  if (!grammar) return grammar.errors();
  const GrammarText& text = grammar->text;
  SizeEstimate seen;
  seen.word = forecast(*grammar, text.steps, seed, text.limits);
  if (Errors errors = refuse(seen.word, text.limits); !errors.empty()) return placed(errors, text);
  seen.nodes = 1 + seen.word.segments * smoothing;
  return seen;
}

}  // namespace frond
