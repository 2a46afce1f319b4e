#include <fmt/format.h>

#include <algorithm>

#include "cpfg/reader.h"

namespace frond::cpfg {

namespace {

constexpr int kDeepestBlock = 200, kMostValues = 10'000'000;

}  // namespace

int GrammarReader::read_block() {
  if (!cursor_.consume("{")) fail(fmt::format("{}: expected `{{`", found()));
  if (++depth_ > kDeepestBlock) fail("blocks stand too deep in each other; expected at most 200 levels");
  bool around = std::exchange(cursor_.in_braces, true);
  std::vector<Statement> statements;
  while (!failed() && !cursor_.is_next("}") && !cursor_.at_item_end()) read_statement(statements);
  if (!failed() && !cursor_.consume("}")) fail("a block has no `}`");
  cursor_.in_braces = around;
  --depth_;
  code_.blocks.push_back(std::move(statements));
  return static_cast<int>(code_.blocks.size()) - 1;
}

int GrammarReader::read_loop_condition() {
  if (!cursor_.consume("(")) fail(fmt::format("{}: expected `(`", found()));
  int formula = failed() ? -1 : read_formula();
  if (!failed() && !cursor_.consume(")")) fail(fmt::format("{}: expected `)`", found()));
  return formula;
}

void GrammarReader::read_statement(std::vector<Statement>& statements) {
  if (cursor_.consume(";")) return;
  std::size_t from = (cursor_.peek(), cursor_.position());
  std::string_view word = consume_name();
  Statement statement{StatementKind::condition};
  if (word == "if") {
    statement.formula = read_loop_condition();
    if (!failed()) statement.body = read_block();
    std::size_t after = cursor_.position();
    if (!failed() && consume_name() != "else")
      cursor_.go_to(after);
    else if (!failed())
      statement.other = read_block();
    statements.push_back(statement);
  } else if (word == "while") {
    statement.kind = StatementKind::loop, statement.place = add_place(from);
    statement.formula = read_loop_condition();
    if (!failed()) statement.body = read_block();
    statements.push_back(statement);
  } else if (word == "do") {
    statement.kind = StatementKind::loop_after, statement.place = add_place(from);
    statement.body = read_block();
    if (!failed() && consume_name() != "while") fail("`do` has no `while`");
    if (!failed()) statement.formula = read_loop_condition();
    statements.push_back(statement);
  } else {
    cursor_.go_to(from);
    read_assignment(statements);
  }
  bool braced = word == "if" || word == "while";
  if (!failed() && !braced && !cursor_.consume(";")) fail(fmt::format("{}: expected `;`", found()));
}

void GrammarReader::read_assignment(std::vector<Statement>& statements) {
  std::size_t from = (cursor_.peek(), cursor_.position());
  bool named = !consume_name().empty();
  cursor_.go_to(from);
  int node = read_formula();
  if (failed()) return;
  bool assigns = cursor_.is_next("=") && !cursor_.is_next("==");
  FormulaNode target = code_.formulas[static_cast<std::size_t>(node)];
  bool takes = target.kind == FormulaKind::variable || target.kind == FormulaKind::local ||
               target.kind == FormulaKind::formal || target.kind == FormulaKind::element;
  // Any formula is a statement, for what its calls do.
  if (!assigns) return statements.push_back({StatementKind::call, -1, node});
  if (!named || !takes)
    return fail(fmt::format("{}: expected a statement, as `name = formula;` or a call", found()));
  cursor_.consume("=");
  Statement statement{StatementKind::assign_variable, target.a, read_formula()};
  if (target.kind == FormulaKind::formal) statement.kind = StatementKind::assign_formal;
  if (target.kind == FormulaKind::local) statement.kind = StatementKind::assign_local;
  if (target.kind == FormulaKind::element) {
    statement.kind = StatementKind::assign_element;
    statement.target = node;
  }
  bool constant = target.kind == FormulaKind::variable && (target.a == kLengthSlot || target.a == kStepSlot);
  if (constant) fail_at(from, "`Z` and `Q` are the derivation length and the step; expected another name");
  statements.push_back(statement);
}

void GrammarReader::read_define() {
  if (!cursor_.consume("{")) return fail(fmt::format("{}: expected `{{`", found()));
  bool around = std::exchange(cursor_.in_braces, true);
  while (!failed() && !cursor_.consume("}")) {
    if (cursor_.consume(";")) continue;
    std::string_view word = consume_name();
    if (word != "array" && word != "external") {
      fail(fmt::format("{}: expected `array` or `external`", found()));
      break;
    }
    do word == "array" ? read_array() : read_external();
    while (!failed() && cursor_.consume(","));
    if (!failed() && !cursor_.is_next("}") && !cursor_.consume(";"))
      fail(fmt::format("{}: expected `;`", found()));
  }
  cursor_.in_braces = around;
}

void GrammarReader::read_array() {
  CpfgArray array;
  array.name = std::string(consume_name());
  array.slot = system_->slots;
  double values = 1;
  while (!failed() && cursor_.consume("[")) {
    int size = static_cast<int>(std::clamp<std::int64_t>(read_whole("an array's size"), 0, kMostValues + 1));
    if (!failed() && (size < 1 || (values *= size) > kMostValues))
      fail("an array has a size of 1 or more and at most 10,000,000 values");
    array.sizes.push_back(size);
    if (!failed() && !cursor_.consume("]")) fail(fmt::format("{}: expected `]`", found()));
  }
  if (!failed() && (array.name.empty() || array.sizes.empty()))
    fail(fmt::format("{}: expected an array, as `a[3]`", found()));
  if (!failed() && cursor_.consume("=")) read_initial(array.initial, 0);
  if (failed()) return;
  if (static_cast<double>(array.initial.size()) > values) return fail("an array has more values than places");
  system_->slots += static_cast<int>(values);
  if (system_->slots > 2 * kMostValues) return fail("the arrays have more than 20,000,000 values");
  system_->arrays.push_back(std::move(array));
}

void GrammarReader::read_initial(std::vector<int>& formulas, int depth) {
  if (!cursor_.consume("{") || depth > 20) return fail(fmt::format("{}: expected `{{` and values", found()));
  do {
    if (cursor_.is_next("{"))
      read_initial(formulas, depth + 1);
    else if (!cursor_.is_next("}"))
      formulas.push_back(read_formula());
  } while (!failed() && cursor_.consume(","));
  if (!failed() && !cursor_.consume("}")) fail(fmt::format("{}: expected `,` or `}}`", found()));
}

void GrammarReader::read_external() {
  std::size_t before = system_->arrays.size();
  int slot = system_->slots;
  std::size_t from = (cursor_.peek(), cursor_.position());
  std::string name(consume_name());
  if (name.empty()) return fail(fmt::format("{}: expected a name", found()));
  if (cursor_.is_next("[")) {
    cursor_.go_to(from);
    read_array();
  } else {
    system_->variables[name] = system_->slots++;
  }
  if (!failed()) system_->externals.push_back({name, slot, system_->slots - slot});
  if (!failed() && system_->arrays.size() > before && !system_->arrays.back().initial.empty())
    fail_at(from, "an external array has its values elsewhere");
}

}  // namespace frond::cpfg
