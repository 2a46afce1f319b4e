#include <fmt/format.h>

#include <algorithm>

#include "cpfg/reader.h"

namespace frond::cpfg {

namespace {

constexpr std::size_t kMostModules = 1'000'000, kMostProductions = 10'000;
constexpr int kMostParameters = 255;

/// Whether a character may be a module.
bool is_symbol(char c) {
  return std::string_view(" \t\n<>:*()").find(c) == std::string_view::npos && c != '\0';
}

bool same_pattern(const std::vector<PatternModule>& a, const std::vector<PatternModule>& b) {
  return std::ranges::equal(a, b, [](const PatternModule& x, const PatternModule& y) {
    return x.symbol == y.symbol && x.count == y.count;
  });
}

}  // namespace

bool GrammarReader::at_arrow() { return cursor_.is_next("-->") || cursor_.is_next("-o>"); }

std::vector<ModuleText> GrammarReader::read_word(bool is_axiom) {
  std::vector<ModuleText> word;
  if (cursor_.consume("*")) return word;
  std::size_t from = cursor_.position();
  while (!failed() && !cursor_.at_item_end() && !cursor_.is_next(":") && word.size() < kMostModules) {
    if (!is_axiom && at_arrow())
      fail(fmt::format("{}: two arrows in one production; a line that goes on begins with a tab", found()));
    if (!is_symbol(cursor_.peek())) fail(fmt::format("{}: expected a module", found()));
    if (failed()) break;
    ModuleText module{cursor_.read_char()};
    if (cursor_.consume("(")) {
      std::vector<int> formulas;
      read_list(')', formulas);
      if (!failed() && (formulas.empty() || formulas.size() > kMostParameters))
        fail(fmt::format("`{}` has {} parameters; expected 1 to 255 in parentheses", module.symbol,
                         formulas.size()));
      module.count = static_cast<int>(formulas.size());
      module.first = add_list(formulas);
    }
    if (module.symbol == 'E' && !word.empty() && word.back().symbol == '?' && word.back().count == 0)
      fail(
          "`?E` asks a program for the environment, which cpfg starts beside it (-e); without it the model "
          "cannot be derived");
    word.push_back(module);
  }
  if (!failed() && word.empty()) fail_at(from, "there is no word; the empty one is written `*`");
  return word;
}

void GrammarReader::read_formals(PatternModule& module) {
  module.first = static_cast<int>(scope_.formals.size());
  if (!cursor_.consume("(")) return;
  do {
    std::string_view name = consume_name();
    if (name.empty()) return fail(fmt::format("{}: expected the name of a parameter", found()));
    scope_.formals.emplace_back(name);
    ++module.count;
  } while (cursor_.consume(","));
  if (!cursor_.consume(")")) fail(fmt::format("{}: expected `,` or `)`", found()));
  if (module.count > kMostParameters) fail("a module has more than 255 parameters");
}

std::vector<PatternModule> GrammarReader::read_pattern() {
  std::vector<PatternModule> pattern;
  if (cursor_.consume("*")) return pattern;
  while (!failed() && !cursor_.at_item_end() && !at_arrow() && is_symbol(cursor_.peek())) {
    PatternModule module{cursor_.read_char()};
    read_formals(module);
    pattern.push_back(module);
  }
  return pattern;
}

void GrammarReader::read_condition(CpfgProduction& production) {
  if (cursor_.is_next("{")) production.before = read_block();
  if (failed() || at_arrow()) return fail("there is no condition before the arrow; expected one, or `*`");
  if (!cursor_.consume("*")) production.condition = read_formula();
  if (!failed() && cursor_.is_next("{")) production.after = read_block();
  if (!failed() && cursor_.is_next("=")) fail("`=` assigns; a comparison is written `==`");
}

void GrammarReader::read_production(ProductionSet& set) {
  std::size_t from = cursor_.position();
  scope_ = {{}, {}, true};
  CpfgProduction production;
  production.where = where(from);
  std::vector<PatternModule> first = read_pattern();
  bool left = cursor_.consume("<");
  std::vector<PatternModule> second = left ? read_pattern() : std::vector<PatternModule>();
  if (!failed() && cursor_.consume(">")) production.right = read_pattern();
  production.predecessor = left ? second : first;
  if (left) production.left = first;
  if (!failed() && production.predecessor.empty())
    return cursor_.go_to(from),
           fail(fmt::format("{}: expected a setting or a production `predecessor --> successor`", found()));
  if (!failed() && cursor_.consume(":")) read_condition(production);
  bool arrow = !failed() && (cursor_.consume("-->") || cursor_.consume("-o>"));
  if (!failed() && !arrow && production.predecessor.back().symbol == '-' && !production.right.empty())
    fail("`->` is no arrow of cpfg; expected `-->`");
  if (!failed() && !arrow)
    fail(fmt::format("{}: expected `-->`; a line that goes on begins with a tab", found()));
  if (!failed()) production.successor = read_word(false);
  if (!failed() && cursor_.consume(":")) production.weight = read_formula();
  if (!failed()) end_item("a production");
  if (!failed() && set.productions.size() >= kMostProductions) fail("more than 10,000 productions");
  if (failed()) return;
  if (production.weight >= 0 && !set.has_seed)
    notes.push_back(production.where + ": the weight has no effect without `Seed:` above");
  production.formals = static_cast<int>(scope_.formals.size());
  code_.formals = std::max(code_.formals, production.formals);
  note_needless(set, production);
  auto symbol = static_cast<unsigned char>(production.predecessor[0].symbol);
  set.of_symbol[symbol].push_back(static_cast<int>(set.productions.size()));
  set.productions.push_back(std::move(production));
}

void GrammarReader::note_needless(const ProductionSet& set, const CpfgProduction& production) {
  auto is_bracket = [](const PatternModule& module) { return module.symbol == '[' || module.symbol == ']'; };
  if (std::ranges::any_of(production.left, is_bracket))
    notes.push_back(production.where + ": never matches, as brackets in a left context do not");
  if (set.has_seed) return;
  for (int index : set.of_symbol[static_cast<unsigned char>(production.predecessor[0].symbol)]) {
    const CpfgProduction& above = set.productions[static_cast<std::size_t>(index)];
    bool always = above.left.empty() && above.right.empty() && above.condition < 0 && above.before < 0;
    if (always && same_pattern(above.predecessor, production.predecessor)) {
      notes.push_back(
          fmt::format("{}: never used, as the production of {} comes first", production.where, above.where));
      return;
    }
  }
}

}  // namespace frond::cpfg
