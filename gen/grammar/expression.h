#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/seed.h"

namespace frond {

/// The operations of the expression machine. Angles are in degrees; truth is 1, falsehood 0.
// clang-format off
enum class Op : std::uint8_t {
  // without operands
  constant, variable, step_number,
  // of one value
  element, ramp, jump_if_false, jump_if_true, negate, logical_not, truth, floor, ceil, round, abs, sign, sqrt, exp,
  log, sin, cos, tan, asin, acos, atan,
  // of two values
  add, subtract, multiply, divide, modulo, power, less, less_equal, greater, greater_equal, equal, not_equal, min,
  max, atan2, rand, nrand,
};
// clang-format on

/// How many values an operation takes off the stack.
constexpr std::size_t operands(Op op) { return op < Op::element ? 0 : op < Op::add ? 1 : 2; }

/// The most values that a formula may need at a time.
inline constexpr std::size_t kHighestStack = 64;

struct Instruction {
  Op op = Op::constant;
  std::uint16_t index = 0;  ///< which variable or table, or where to jump
  double value = 0;         ///< of a constant
};

/// A compiled formula. Most formulas of a grammar are a number, a parameter or their product: these are kept
/// apart, so that evaluating them runs no machine.
struct Expression {
  enum class Form : std::uint8_t { constant, variable, scaled, code };

  Form form = Form::constant;
  std::uint16_t variable = 0;
  double value = 0;
  std::vector<Instruction> code;
};

/// What a formula is evaluated against.
struct Evaluation {
  const double* frame = nullptr;  ///< the parameters of the rule, in the order of their variables
  std::span<const std::vector<double>> tables;  ///< the arrays among the constants
  Seed seed;                                    ///< place of the module in the derivation
  double step = 0;                              ///< number of the step being made, from 1
  std::uint32_t draws = 0;                      ///< random numbers taken so far
  bool fault = false;                           ///< set by a division by zero or an element that is not there
};

/// Sine of degrees, exact where it is a whole number.
double sine(double degrees);

/// Runs the code of a formula; the general case of evaluate().
double run(const Expression& formula, Evaluation& at);

/// The value of a formula. Never stops: what went wrong is in `at.fault`, or the value is not finite.
inline double evaluate(const Expression& formula, Evaluation& at) {
  switch (formula.form) {
    case Expression::Form::constant:
      return formula.value;
    case Expression::Form::variable:
      return at.frame[formula.variable];
    case Expression::Form::scaled:
      return at.frame[formula.variable] * formula.value;
    case Expression::Form::code:
      return run(formula, at);
  }
  return 0;
}

/// A named number, or a named array of numbers.
struct Constant {
  std::string name;
  std::vector<double> values;  ///< one for a number
  bool array = false;
  std::uint16_t table = 0;  ///< which of the tables, for an array
};

/// The names that a formula may use.
struct Scope {
  std::span<const std::string> variables;
  std::span<const Constant> constants;
};

/// A place in a text being read, and the first mistake met there. Once there is a mistake nothing more is
/// read.
struct Cursor {
  std::string_view text;
  std::size_t at = 0;
  std::string mistake = {};
  std::size_t mistake_at = 0;

  bool failed() const { return !mistake.empty(); }
  void skip_blanks();
  /// Steps over `word` after blanks, where it stands next.
  bool take(std::string_view word);
  bool at_end() { return skip_blanks(), at >= text.size(); }
  /// Keeps the first mistake.
  void fail(std::string what, std::size_t where);
};

/// Reads one formula and stops behind it. `=` and `==` both compare.
Expression read_expression(Cursor& reader, const Scope& scope);

/// Whether a name may be given to a parameter or a constant: letters, digits and `_`, no digit first.
bool is_identifier(std::string_view name);

/// Reads an identifier after blanks; empty where there is none.
std::string_view take_identifier(Cursor& reader);

}  // namespace frond
