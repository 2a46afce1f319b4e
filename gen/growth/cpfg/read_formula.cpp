#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "cpfg/macros.h"
#include "cpfg/reader.h"

namespace frond::cpfg {

namespace {

constexpr int kDeepestFormula = 300;
constexpr std::size_t kLongestFormula = 10'000;

}  // namespace

int GrammarReader::add(FormulaNode node) {
  code_.formulas.push_back(node);
  if (code_.formulas.size() > formula_start_ + kLongestFormula) fail("a formula has more than 10,000 parts");
  return static_cast<int>(code_.formulas.size()) - 1;
}

int GrammarReader::add_list(const std::vector<int>& nodes) {
  code_.lists.insert(code_.lists.end(), nodes.begin(), nodes.end());
  return static_cast<int>(code_.lists.size() - nodes.size());
}

std::string_view GrammarReader::consume_name() {
  char c = cursor_.peek();
  bool letter = is_name_letter(c) && !(c >= '0' && c <= '9') && c != '_';
  std::string_view name = cursor_.rest().substr(0, letter ? name_length(cursor_.rest()) : 0);
  cursor_.go_to(cursor_.position() + name.size());
  return name;
}

int GrammarReader::read_formula() {
  if (++depth_ > kDeepestFormula) fail("formulas stand too deep in each other; expected at most 300 levels");
  if (formula_depth_++ == 0) formula_start_ = code_.formulas.size();
  int node = failed() ? -1 : read_choice();
  --depth_;
  --formula_depth_;
  return node;
}

int GrammarReader::read_choice() {
  int condition = read_binary(1);
  if (failed() || !cursor_.consume("?")) return condition;
  int yes = read_formula();
  if (!failed() && !cursor_.consume(":")) fail(fmt::format("{}: expected `:` of `? :`", found()));
  int no = failed() ? -1 : read_formula();
  return add({FormulaKind::choice, condition, yes, no});
}

int GrammarReader::read_binary(int strength) {
  int left = read_unary();
  while (!failed() && !at_arrow()) {
    cursor_.peek();
    std::span<const BinaryOperator> all = binary_operators();
    auto op = std::ranges::find_if(
        all, [&](const BinaryOperator& row) { return cursor_.rest().starts_with(row.sign); });
    if (op == all.end() || op->strength < strength) break;
    cursor_.consume(op->sign);
    int right = read_binary(op->strength + 1);
    left = add({op->kind, left, right, static_cast<int>(op - all.begin())});
  }
  return left;
}

int GrammarReader::read_unary() {
  char c = cursor_.peek();
  if (c != '-' && c != '!' && c != '&') return read_primary();
  if (at_arrow()) {
    fail(fmt::format("{}: expected a number, a name or `(`", found()));
    return -1;
  }
  if (++depth_ > kDeepestFormula) fail("formulas stand too deep in each other; expected at most 300 levels");
  cursor_.read_char();
  bool more = std::string_view("-!&").find(cursor_.peek()) != std::string_view::npos;
  int node = failed() ? -1 : c == '!' && !more ? read_primary() : read_unary();
  --depth_;
  return c == '&' ? node : add({c == '-' ? FormulaKind::negate : FormulaKind::negation, node});
}

int GrammarReader::read_primary() {
  char c = cursor_.peek();
  if (cursor_.consume("(")) {
    int node = read_formula();
    if (!failed() && !cursor_.consume(")")) fail(fmt::format("{}: expected `)`", found()));
    return node;
  }
  if ((c >= '0' && c <= '9') || c == '.') return read_number();
  if (std::size_t length = c == '"' ? string_length(cursor_.rest()) : 0) {
    code_.strings.emplace_back(cursor_.rest().substr(1, length - 2));
    cursor_.go_to(cursor_.position() + length);
    return add({FormulaKind::string, static_cast<int>(code_.strings.size()) - 1});
  }
  return read_name();
}

int GrammarReader::read_number() {
  std::string_view rest = cursor_.rest();
  auto digits = [&](std::size_t at) {
    std::size_t length = 0;
    while (at + length < rest.size() && rest[at + length] >= '0' && rest[at + length] <= '9') ++length;
    return length;
  };
  std::size_t length = digits(0);
  bool point = rest.substr(length).starts_with('.');
  if (point) length += 1 + digits(length + 1);
  if (point && length > 1 && (rest.substr(length).starts_with('e') || rest.substr(length).starts_with('E'))) {
    std::size_t sign = length + 1 < rest.size() && (rest[length + 1] == '-' || rest[length + 1] == '+');
    if (std::size_t exponent = digits(length + 1 + sign)) length += 1 + sign + exponent;
  }
  std::string number = "0" + std::string(rest.substr(0, length));  // `.5`
  double value = 0;
  auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error != std::errc{} || length == (point ? 1 : 0))
    fail(fmt::format("`{}` is no number", rest.substr(0, std::max<std::size_t>(length, 1))));
  cursor_.go_to(cursor_.position() + length);
  FormulaNode node{FormulaKind::number};
  node.value = value;
  return add(node);
}

int GrammarReader::slot_of(std::string_view name, FormulaKind& kind) {
  auto formal = std::ranges::find(scope_.formals, name);
  if (formal != scope_.formals.end()) {
    kind = FormulaKind::formal;
    return static_cast<int>(formal - scope_.formals.begin());
  }
  kind = FormulaKind::variable;
  if (auto known = system_->variables.find(name); known != system_->variables.end()) return known->second;
  if (!scope_.keeps_locals) return system_->variables[std::string(name)] = system_->slots++;
  kind = FormulaKind::local;
  for (const auto& [local, slot] : scope_.locals)
    if (local == name) return slot;
  scope_.locals.emplace_back(name, code_.locals);
  return code_.locals++;
}

int GrammarReader::array_of(std::string_view name) const {
  for (std::size_t i = 0; i < system_->arrays.size(); ++i)
    if (system_->arrays[i].name == name) return static_cast<int>(i);
  return -1;
}

int GrammarReader::read_name() {
  cursor_.peek();
  std::size_t from = cursor_.position();
  std::string_view name = consume_name();
  if (name.empty()) {
    fail(fmt::format("{}: expected a number, a name or `(`", found()));
    return -1;
  }
  if (cursor_.consume("(")) return read_call(name, from);
  bool formal = std::ranges::find(scope_.formals, name) != scope_.formals.end();
  if (int array = array_of(name); array >= 0 && !formal) return read_element(array, from);
  FormulaNode node{FormulaKind::variable};
  node.a = slot_of(name, node.kind);
  return add(node);
}

bool GrammarReader::read_list(char closing, std::vector<int>& nodes) {
  std::string sign(1, closing);
  if (cursor_.consume(sign)) return true;
  do nodes.push_back(read_formula());
  while (!failed() && cursor_.consume(","));
  if (!failed() && !cursor_.consume(sign)) fail(fmt::format("{}: expected `,` or `{}`", found(), closing));
  return !failed();
}

int GrammarReader::read_call(std::string_view name, std::size_t from) {
  std::vector<int> arguments;
  if (!read_list(')', arguments)) return -1;
  std::span<const FormulaFunction> all = formula_functions();
  auto row = std::ranges::find(all, name, &FormulaFunction::name);
  int count = static_cast<int>(arguments.size());
  if (row == all.end()) {
    fail_at(from, fmt::format("cpfg has no function `{}`", name));
  } else if (!row->refused.empty()) {
    fail_at(from, fmt::format("`{}` {}", name, row->refused));
  } else if (count < row->least || count > row->most) {
    fail_at(from, fmt::format("`{}` has {} arguments; expected {}", name, count, row->least));
  }
  if (failed()) return -1;
  if (!row->value) notes.push_back(fmt::format("{}: `{}` has no effect", where(from), name));
  FormulaNode node{FormulaKind::call, static_cast<int>(row - all.begin()), add_list(arguments), count};
  node.line = add_place(from);
  return add(node);
}

int GrammarReader::read_element(int array, std::size_t from) {
  const std::size_t sizes = system_->arrays[static_cast<std::size_t>(array)].sizes.size();
  std::vector<int> indices;
  while (!failed() && cursor_.consume("[")) {
    indices.push_back(read_formula());
    if (!failed() && !cursor_.consume("]")) fail(fmt::format("{}: expected `]`", found()));
  }
  if (!failed() && indices.size() != sizes)
    fail_at(from, fmt::format("the array has {} indices here; expected {}", indices.size(), sizes));
  if (failed()) return -1;
  return add({FormulaKind::element, array, add_list(indices), static_cast<int>(indices.size())});
}

}  // namespace frond::cpfg
