#include <algorithm>
#include <cmath>

#include "core/vec.h"
#include "grammar/expression.h"

namespace frond {

double sine(double angle) {
  double turns = std::fmod(angle, 360.0);
  if (std::fmod(turns, 90.0) == 0) {
    static constexpr double kQuarter[4] = {0, 1, 0, -1};
    return kQuarter[(static_cast<int>(turns / 90.0) + 4) % 4];
  }
  return std::sin(radians(turns));
}

namespace {

double element_of(const std::vector<double>& table, double index, std::uint32_t place, Evaluation& at) {
  if (!(index >= 0 && index < static_cast<double>(table.size())))
    return at.fail(FormulaFault::no_element, place), 0.0;
  return table[static_cast<std::size_t>(index)];
}

double ramp_of(const std::vector<double>& table, double at) {
  if (!(at > 0)) return table.front();
  if (at >= 1) return table.back();
  double place = at * static_cast<double>(table.size() - 1);
  auto i = static_cast<std::size_t>(place);
  double share = place - static_cast<double>(i);
  return i + 1 < table.size() ? table[i] + (table[i + 1] - table[i]) * share : table.back();
}

/// Those from Op::negate to Op::atan, in their order.
constexpr double (*kOfOneValue[])(double) = {
    [](double x) { return -x; },
    [](double x) { return x == 0 ? 1.0 : 0.0; },
    [](double x) { return x != 0 ? 1.0 : 0.0; },
    [](double x) { return std::floor(x); },
    [](double x) { return std::ceil(x); },
    [](double x) { return std::round(x); },
    [](double x) { return std::abs(x); },
    [](double x) { return static_cast<double>(x > 0) - static_cast<double>(x < 0); },
    [](double x) { return std::sqrt(x); },
    [](double x) { return std::exp(x); },
    [](double x) { return std::log(x); },
    sine,
    [](double x) { return sine(x + 90.0); },
    [](double x) { return std::tan(radians(x)); },
    [](double x) { return degrees(std::asin(x)); },
    [](double x) { return degrees(std::acos(x)); },
    [](double x) { return degrees(std::atan(x)); },
};
constexpr auto kFirstOfOne = static_cast<std::size_t>(Op::negate);
static_assert(std::size(kOfOneValue) == static_cast<std::size_t>(Op::atan) + 1 - kFirstOfOne);

double binary(const Instruction& now, double a, double b, Evaluation& at) {
  auto by_zero = [&] { return at.fail(FormulaFault::zero_division, now.place), 0.0; };
  switch (now.op) {
    case Op::add:
      return a + b;
    case Op::subtract:
      return a - b;
    case Op::multiply:
      return a * b;
    case Op::divide:
      return b == 0 ? by_zero() : a / b;
    case Op::modulo:
      return b == 0 ? by_zero() : std::fmod(a, b);
    case Op::power:
      return std::pow(a, b);
    case Op::less:
      return a < b;
    case Op::less_equal:
      return a <= b;
    case Op::greater:
      return a > b;
    case Op::greater_equal:
      return a >= b;
    case Op::equal:
      return a == b;
    case Op::not_equal:
      return a != b;
    case Op::min:
      return std::min(a, b);
    case Op::max:
      return std::max(a, b);
    case Op::atan2:
      return degrees(std::atan2(a, b));
    case Op::rand:
      return at.seed.child(++at.draws).range(a, b);
    case Op::nrand:
      return a + b * at.seed.child(++at.draws).normal();
    default:
      return 0;
  }
}

}  // namespace

double run(const Expression& formula, Evaluation& at) {
  double stack[kHighestStack + 1];
  double* top = stack;  // the first place stays empty
  const Instruction* code = formula.code.data();
  for (std::size_t i = 0, n = formula.code.size(); i < n; ++i) {
    const Instruction& now = code[i];
    switch (now.op) {
      case Op::constant:
        *++top = now.value;
        break;
      case Op::variable:
        *++top = at.frame[now.index];
        break;
      case Op::step_number:
        *++top = at.step;
        break;
      case Op::element:
        *top = element_of(at.tables[now.index], *top, now.place, at);
        break;
      case Op::ramp:
        *top = ramp_of(at.tables[now.index], *top);
        break;
      case Op::add:
        --top, top[0] += top[1];
        break;
      case Op::subtract:
        --top, top[0] -= top[1];
        break;
      case Op::multiply:
        --top, top[0] *= top[1];
        break;
      case Op::jump_if_false:
      case Op::jump_if_true:
        *top = *top != 0;
        if ((*top != 0) == (now.op == Op::jump_if_true))
          i = now.index - std::size_t{1};
        else
          --top;
        break;
      default:
        if (operands(now.op) == 1) {
          *top = kOfOneValue[static_cast<std::size_t>(now.op) - kFirstOfOne](*top);
        } else {
          --top;
          top[0] = binary(now, top[0], top[1], at);
        }
    }
  }
  return *top;
}

}  // namespace frond
