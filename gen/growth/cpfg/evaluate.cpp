#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cpfg/run.h"

namespace frond::cpfg {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// A number cut to a whole one; what no long integer holds becomes the nearest.
std::int64_t whole(double value) {
  return std::isnan(value) ? 0 : static_cast<std::int64_t>(std::clamp(value, -9e18, 9e18));
}

const FormulaNode& node_at(const Code& code, int node) {
  return code.formulas[static_cast<std::size_t>(node)];
}

int argument(const Code& code, const FormulaNode& node, int index) {
  return code.lists[static_cast<std::size_t>(node.b + index)];
}

double divide(Run& run, double a, double b) {
  if (b != 0) return a / b;
  run.notes.insert("a division by 0 divides by 1, as in cpfg");
  return a;
}

/// The slot of an element; an index out of range is moved to the nearest end.
int element_slot(Run& run, const FormulaNode& node) {
  const CpfgArray& array = run.system().arrays[static_cast<std::size_t>(node.a)];
  int offset = 0;
  for (int i = 0; i < node.c; ++i) {
    int size = array.sizes[static_cast<std::size_t>(i)];
    std::int64_t index = whole(evaluate(run, argument(run.code, node, i)));
    offset = offset * size + static_cast<int>(std::clamp<std::int64_t>(index, 0, size - 1));
  }
  return array.slot + offset;
}

/// The entry of a table by its number from 1; nothing where there is none, which counts as 0.
template <class Table>
const Table* table_of(Run& run, const std::vector<Table>& tables, double number, const FormulaNode& node,
                      std::string_view what) {
  std::int64_t index = whole(number);
  if (index >= 1 && index <= static_cast<std::int64_t>(tables.size()))
    return &tables[static_cast<std::size_t>(index - 1)];
  run.notes.insert(fmt::format("{}: {} that is asked for counts as 0, as in cpfg; the view has {}",
                               run.code.places[static_cast<std::size_t>(node.line)], what, tables.size()));
  return nullptr;
}

double look_up(Run& run, const FormulaNode& node, Function function, double a, double b) {
  if (function == Function::func) {
    const FunctionTable* table = table_of(run, run.code.functions, a, node, "the function");
    return table ? (*table)(b) : 0;
  }
  const CurveTable* curve = table_of(run, run.code.curves, a, node, "the curve");
  if (!curve) return 0;
  if (function == Function::curve_length) return curve->length.back();
  return (*curve)(b)[static_cast<std::size_t>(function) - static_cast<std::size_t>(Function::curve_x)];
}

double call_mathematics(Function function, double a) {
  switch (function) {
    case Function::sin:
      return std::sin(a * kDegree);
    case Function::cos:
      return std::cos(a * kDegree);
    case Function::tan:
      return std::tan(a * kDegree);
    case Function::asin:
      return std::asin(a) / kDegree;
    case Function::acos:
      return std::acos(a) / kDegree;
    case Function::atan:
      return std::atan(a) / kDegree;
    case Function::exp:
      return std::exp(a);
    case Function::log:
      return std::log(a);
    case Function::sqrt:
      return std::sqrt(a);
    case Function::floor:
      return std::floor(a);
    case Function::ceil:
      return std::ceil(a);
    case Function::trunc:
      return std::floor(a + 0.5);
    case Function::fabs:
      return std::abs(a);
    default:
      return (a > 0) - (a < 0);
  }
}

double call(Run& run, const FormulaNode& node) {
  double a = 0, b = 0;
  for (int i = 0; i < node.c; ++i) {
    double value = evaluate(run, argument(run.code, node, i));
    if (i == 0) a = value;
    if (i == 1) b = value;
  }
  auto function = static_cast<Function>(node.a);
  switch (function) {
    case Function::ran:
      return a * run.chance.stream.next();
    case Function::nran:
      return normal_number(run.chance) * b + a;
    case Function::bran:
      return beta_number(run.chance, a, b);
    case Function::biran:
      return binomial_number(run.chance, a, b);
    case Function::srand:
      return seed_chance(run.chance, whole(a), run.variation), 0;
    case Function::func:
    case Function::curve_x:
    case Function::curve_y:
    case Function::curve_z:
    case Function::curve_length:
      return look_up(run, node, function, a, b);
    case Function::print:
      return 0;
    case Function::stop:
      return run.stopped = run.stopped || a != 1, 0;  // 1 only pauses
    case Function::get_length:
      return run.length;
    case Function::set_length:
      run.length = std::clamp(std::isnan(a) ? 0 : std::trunc(a), 0.0, 1e9);
      if (!run.instances.empty()) run.instances[0].values[kLengthSlot] = run.length;
      return 0;
    default:
      return call_mathematics(function, a);
  }
}

double binary(Run& run, FormulaKind kind, double a, double b) {
  switch (kind) {
    case FormulaKind::add:
      return a + b;
    case FormulaKind::subtract:
      return a - b;
    case FormulaKind::multiply:
      return a * b;
    case FormulaKind::divide:
      return divide(run, a, b);
    case FormulaKind::remainder: {
      std::int64_t x = whole(a), y = whole(b);
      if (y == 0) run.notes.insert("a division by 0 divides by 1, as in cpfg");
      return y == 0 ? 0 : static_cast<double>(x % y);
    }
    case FormulaKind::power:
      return std::pow(a, b);
    case FormulaKind::less:
      return a < b;
    case FormulaKind::at_most:
      return a <= b;
    case FormulaKind::more:
      return a > b;
    case FormulaKind::at_least:
      return a >= b;
    case FormulaKind::equal:
      return a == b;
    default:
      return a != b;
  }
}

}  // namespace

const CpfgSystem& Run::system() const {
  int index = instances.empty() ? 0 : instances[static_cast<std::size_t>(instance)].system;
  return code.systems[static_cast<std::size_t>(index)];
}

bool Run::goes_on(std::uint64_t more) {
  work += more;
  if (work > limits.work && !error)
    fail("", fmt::format("more than {} operations; the model may go on without end", limits.work));
  return !error;
}

bool Run::turns_on(int place) {
  if (++turns > limits.turns)
    fail(code.places[static_cast<std::size_t>(place)],
         fmt::format("the loop has made {} turns; it may go on without end", limits.turns));
  return !error;
}

void Run::fail(std::string where, std::string what) {
  if (!error) error = Error{std::move(where), std::move(what)};
}

double& variable(Run& run, int slot) {
  SystemInstance& own = run.instances[static_cast<std::size_t>(run.instance)];
  const std::vector<ExternalName>& names = run.code.systems[static_cast<std::size_t>(own.system)].externals;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (slot < names[i].slot || slot >= names[i].slot + names[i].count || own.externals[i].instance < 0)
      continue;
    SystemInstance& other = run.instances[static_cast<std::size_t>(own.externals[i].instance)];
    return other.values[static_cast<std::size_t>(own.externals[i].slot + slot - names[i].slot)];
  }
  return own.values[static_cast<std::size_t>(slot)];
}

double evaluate(Run& run, int formula) {
  if (!run.goes_on()) return 0;
  const FormulaNode& node = node_at(run.code, formula);
  switch (node.kind) {
    case FormulaKind::number:
      return node.value;
    case FormulaKind::string:
      return string_number(node.a);
    case FormulaKind::formal:
      return run.formals[static_cast<std::size_t>(node.a)];
    case FormulaKind::local:
      return run.locals[static_cast<std::size_t>(node.a)];
    case FormulaKind::variable:
      return run.instances.empty() ? 0 : variable(run, node.a);
    case FormulaKind::element:
      return run.instances.empty() ? 0 : variable(run, element_slot(run, node));
    case FormulaKind::negate:
      return -evaluate(run, node.a);
    case FormulaKind::negation:
      return evaluate(run, node.a) == 0;
    case FormulaKind::both:
      return evaluate(run, node.a) != 0 && evaluate(run, node.b) != 0;
    case FormulaKind::either:
      return evaluate(run, node.a) != 0 || evaluate(run, node.b) != 0;
    case FormulaKind::choice:
      return evaluate(run, evaluate(run, node.a) != 0 ? node.b : node.c);
    case FormulaKind::call:
      return call(run, node);
    default:
      break;
  }
  double a = evaluate(run, node.a);
  return binary(run, node.kind, a, evaluate(run, node.b));
}

double constant_of(const Code& code, int formula) {
  Run run = begin_run(code, {});
  run.locals.assign(static_cast<std::size_t>(code.locals), 0);
  double value = evaluate(run, formula);
  return run.error ? std::nan("") : value;
}

namespace {

void carry_out_loop(Run& run, const Statement& loop) {
  if (run.loops++ == 0) run.turns = 0;
  bool more = loop.kind == StatementKind::loop_after || evaluate(run, loop.formula) != 0;
  while (more && run.turns_on(loop.place)) {
    carry_out(run, loop.body);
    more = evaluate(run, loop.formula) != 0;
  }
  --run.loops;
}

}  // namespace

void carry_out(Run& run, int block) {
  if (block < 0) return;
  for (const Statement& statement : run.code.blocks[static_cast<std::size_t>(block)]) {
    if (!run.goes_on()) return;
    auto target = static_cast<std::size_t>(std::max(statement.target, 0));
    auto holds = [&] { return evaluate(run, statement.formula) != 0 && !run.error; };
    switch (statement.kind) {
      case StatementKind::assign_local:
        run.locals[target] = evaluate(run, statement.formula);
        break;
      case StatementKind::assign_formal:
        run.formals[target] = evaluate(run, statement.formula);
        break;
      case StatementKind::assign_variable: {
        double value = evaluate(run, statement.formula);
        variable(run, statement.target) = value;
        break;
      }
      case StatementKind::assign_element: {
        double value = evaluate(run, statement.formula);
        variable(run, element_slot(run, node_at(run.code, statement.target))) = value;
        break;
      }
      case StatementKind::call:
        evaluate(run, statement.formula);
        break;
      case StatementKind::condition:
        carry_out(run, holds() ? statement.body : statement.other);
        break;
      case StatementKind::loop:
      case StatementKind::loop_after:
        carry_out_loop(run, statement);
        break;
    }
  }
}

}  // namespace frond::cpfg
