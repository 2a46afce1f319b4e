#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cpfg/run.h"

namespace frond::cpfg {

/// A call whose arguments have their values.
struct FunctionCall {
  Run& run;
  const FormulaNode& node;
  double a, b;  ///< the first two; 0 where there are fewer
};

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// A number cut to a whole one; what no long integer holds becomes the nearest.
std::int64_t whole(double value) {
  return std::isnan(value) ? 0 : static_cast<std::int64_t>(std::clamp(value, -9e18, 9e18));
}

const FormulaNode& node_at(const Code& code, int node) { return code.formulas[node]; }

int argument(const Code& code, const FormulaNode& node, int index) { return code.lists[node.b + index]; }

double divide(Run& run, double a, double b) {
  if (b != 0) return a / b;
  run.notes.insert("a division by 0 divides by 1, as in cpfg");
  return a;
}

double remainder(Run& run, double a, double b) {
  std::int64_t x = whole(a), y = whole(b);
  return y == 0 ? divide(run, 0, 0) : static_cast<double>(x % y);
}

constexpr BinaryOperator kOperators[] = {
    {"||", 1, nullptr, FormulaKind::either},
    {"&&", 2, nullptr, FormulaKind::both},
    {"==", 3, [](Run&, double a, double b) { return a == b ? 1.0 : 0.0; }},
    {"!=", 3, [](Run&, double a, double b) { return a != b ? 1.0 : 0.0; }},
    {"<>", 3, [](Run&, double a, double b) { return a != b ? 1.0 : 0.0; }},
    {"<=", 4, [](Run&, double a, double b) { return a <= b ? 1.0 : 0.0; }},
    {">=", 4, [](Run&, double a, double b) { return a >= b ? 1.0 : 0.0; }},
    {"<", 4, [](Run&, double a, double b) { return a < b ? 1.0 : 0.0; }},
    {">", 4, [](Run&, double a, double b) { return a > b ? 1.0 : 0.0; }},
    {"+", 5, [](Run&, double a, double b) { return a + b; }},
    {"-", 5, [](Run&, double a, double b) { return a - b; }},
    {"*", 6, [](Run&, double a, double b) { return a * b; }},
    {"/", 6, divide},
    {"%", 6, remainder},
    {"^", 7, [](Run&, double a, double b) { return std::pow(a, b); }}};

/// The slot of an element; an index out of range is moved to the nearest end.
int element_slot(Run& run, const FormulaNode& node) {
  const CpfgArray& array = run.system().arrays[node.a];
  int offset = 0;
  for (int i = 0; i < node.c; ++i) {
    int size = array.sizes[i];
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
  if (index >= 1 && index <= static_cast<std::int64_t>(tables.size())) return &tables[index - 1];
  run.notes.insert(fmt::format("{}: {} that is asked for counts as 0, as in cpfg; the view has {}",
                               run.code.places[node.line], what, tables.size()));
  return nullptr;
}

const CurveTable* curve_of(const FunctionCall& call) {
  return table_of(call.run, call.run.code.curves, call.a, call.node, "the curve");
}

template <int kAxis>
double on_curve(const FunctionCall& call) {
  const CurveTable* curve = curve_of(call);
  return curve ? (*curve)(call.b)[kAxis] : 0;
}

double set_length(const FunctionCall& call) {
  Run& run = call.run;
  run.length = std::clamp(std::isnan(call.a) ? 0 : std::trunc(call.a), 0.0, 1e9);
  if (!run.instances.empty()) run.instances[0].values[kLengthSlot] = run.length;
  return 0;
}

using Call = const FunctionCall&;
constexpr std::string_view kWindow = "asks for the window of cpfg, which is not there";
constexpr FormulaFunction kFunctions[] = {
    {"sin", 1, 1, [](Call call) { return std::sin(call.a * kDegree); }},
    {"cos", 1, 1, [](Call call) { return std::cos(call.a * kDegree); }},
    {"tan", 1, 1, [](Call call) { return std::tan(call.a * kDegree); }},
    {"asin", 1, 1, [](Call call) { return std::asin(call.a) / kDegree; }},
    {"acos", 1, 1, [](Call call) { return std::acos(call.a) / kDegree; }},
    {"atan", 1, 1, [](Call call) { return std::atan(call.a) / kDegree; }},
    {"exp", 1, 1, [](Call call) { return std::exp(call.a); }},
    {"log", 1, 1, [](Call call) { return std::log(call.a); }},
    {"sqrt", 1, 1, [](Call call) { return std::sqrt(call.a); }},
    {"floor", 1, 1, [](Call call) { return std::floor(call.a); }},
    {"ceil", 1, 1, [](Call call) { return std::ceil(call.a); }},
    {"trunc", 1, 1, [](Call call) { return std::floor(call.a + 0.5); }},
    {"fabs", 1, 1, [](Call call) { return std::abs(call.a); }},
    {"sign", 1, 1, [](Call call) { return static_cast<double>((call.a > 0) - (call.a < 0)); }},
    {"ran", 1, 1, [](Call call) { return call.a * call.run.chance.stream.next(); }},
    {"nran", 2, 2, [](Call call) { return normal_number(call.run.chance) * call.b + call.a; }},
    {"bran", 2, 2, [](Call call) { return beta_number(call.run.chance, call.a, call.b); }},
    {"biran", 2, 2, [](Call call) { return binomial_number(call.run.chance, call.a, call.b); }},
    {"srand", 1, 1,
     [](Call call) { return seed_chance(call.run.chance, whole(call.a), call.run.variation), 0.0; }},
    {"func", 2, 2,
     [](Call call) {
       const FunctionTable* table =
           table_of(call.run, call.run.code.functions, call.a, call.node, "the function");
       return table ? (*table)(call.b) : 0;
     }},
    {"curveX", 2, 2, on_curve<0>},
    {"curveY", 2, 2, on_curve<1>},
    {"curveZ", 2, 2, on_curve<2>},
    {"curveGAL", 1, 1,
     [](Call call) {
       const CurveTable* curve = curve_of(call);
       return curve ? curve->length.back() : 0;
     }},
    {"stop", 1, 1, [](Call call) { return call.run.stopped |= call.a != 1, 0.0; }},  // 1 only pauses
    {"GetDerivationLength", 1, 1, [](Call call) { return call.run.length; }},
    {"SetDerivationLength", 1, 1, set_length},
    {"printf", 1, 99, nullptr},
    {"fopen", 2, 2, nullptr},
    {"fprintf", 2, 99, nullptr},
    {"fclose", 1, 1, nullptr},
    {"fflush", 1, 1, nullptr},
    {"play", 0, 99, nullptr},
    {"Display", 1, 1, nullptr},
    {"fscanf", 0, 99, nullptr, "reads numbers from a file while the model grows; write them into the model"},
    {"inblob", 0, 99, nullptr, "asks for blobs, which are not there"},
    {"vvXmin", 0, 99, nullptr, kWindow},
    {"vvXmax", 0, 99, nullptr, kWindow},
    {"vvYmin", 0, 99, nullptr, kWindow},
    {"vvYmax", 0, 99, nullptr, kWindow},
    {"vvZmin", 0, 99, nullptr, kWindow},
    {"vvZmax", 0, 99, nullptr, kWindow},
    {"vvScale", 0, 99, nullptr, kWindow},
    {"atan2", 0, 99, nullptr, "is a name of cpfg that it cannot call"},
};

double call(Run& run, const FormulaNode& node) {
  double values[2] = {0, 0};
  for (int i = 0; i < node.c; ++i) {
    double value = evaluate(run, argument(run.code, node, i));
    if (i < 2) values[i] = value;
  }
  const FormulaFunction& function = kFunctions[node.a];
  return function.value ? function.value({run, node, values[0], values[1]}) : 0;
}

}  // namespace

std::span<const FormulaFunction> formula_functions() { return kFunctions; }
std::span<const BinaryOperator> binary_operators() { return kOperators; }

const CpfgSystem& Run::system() const {
  int index = instances.empty() ? 0 : instances[instance].system;
  return code.systems[index];
}

bool Run::goes_on(std::uint64_t more) {
  work += more;
  if (work > limits.work && !error)
    fail("", fmt::format("more than {} operations; the model may go on without end", limits.work));
  return !error;
}

bool Run::turns_on(int place) {
  if (++turns > limits.turns)
    fail(code.places[place],
         fmt::format("the loop has made {} turns; it may go on without end", limits.turns));
  return !error;
}

void Run::fail(std::string where, std::string what) {
  if (!error) error = Error{std::move(where), std::move(what)};
}

double& variable(Run& run, int slot) {
  SystemInstance& own = run.instances[run.instance];
  const std::vector<ExternalName>& names = run.code.systems[own.system].externals;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (slot < names[i].slot || slot >= names[i].slot + names[i].count || own.externals[i].instance < 0)
      continue;
    SystemInstance& other = run.instances[own.externals[i].instance];
    return other.values[own.externals[i].slot + slot - names[i].slot];
  }
  return own.values[slot];
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
      return run.formals[node.a];
    case FormulaKind::local:
      return run.locals[node.a];
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
    case FormulaKind::operation:
      break;
  }
  double a = evaluate(run, node.a);
  return kOperators[node.c].value(run, a, evaluate(run, node.b));
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
  for (const Statement& statement : run.code.blocks[block]) {
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
      case StatementKind::assign_variable:  // what is assigned is evaluated first
        variable(run, statement.target) = evaluate(run, statement.formula);
        break;
      case StatementKind::assign_element:
        variable(run, element_slot(run, node_at(run.code, statement.target))) =
            evaluate(run, statement.formula);
        break;
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
