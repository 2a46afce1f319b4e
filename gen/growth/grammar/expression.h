#pragma once

#include <cmath>
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

/// Number of values that an operation takes off the stack.
constexpr std::size_t operands(Op op) { return op < Op::element ? 0 : op < Op::add ? 1 : 2; }

/// Maximum stack size of a formula.
inline constexpr std::size_t kHighestStack = 64;

struct Instruction {
  Op op = Op::constant;
  std::uint16_t index = 0;  ///< index of a variable or table, or jump target
  std::uint32_t place = 0;  ///< offset of its sign in the text, where it may fail
  double value = 0;         ///< of a constant
};

/// A compiled formula. Most formulas are a number, a parameter or their product; these are stored separately
/// and evaluated without the stack machine.
struct Expression {
  enum class Form : std::uint8_t { constant, variable, scaled, code };

  Form form = Form::constant;
  std::uint16_t variable = 0;
  std::uint32_t place = 0;  ///< offset in the text that it was read from
  double value = 0;
  std::vector<Instruction> code;
};

/// Why a formula has no value that can be used.
enum class FormulaFault : std::uint8_t { none, zero_division, no_element, not_finite, bad_weight };

/// The context in which a formula is evaluated.
struct Evaluation {
  const double* frame = nullptr;  ///< the parameters of the rule, in the order of their variables
  std::span<const std::vector<double>> tables;  ///< the arrays among the constants
  Seed seed;                                    ///< place of the module in the derivation
  double step = 0;                              ///< number of the step being made, from 1
  std::uint32_t draws = 0;                      ///< random numbers taken so far
  FormulaFault fault = FormulaFault::none;      ///< the first that occurred
  std::uint32_t fault_place = 0;                ///< its offset in the text

  bool failed() const { return fault != FormulaFault::none; }
  void fail(FormulaFault why, std::uint32_t place) {
    if (fault == FormulaFault::none) fault = why, fault_place = place;
  }
};

/// Sine of an angle in degrees, exact where the result is a whole number.
double sine(double degrees);

/// Runs the code of a formula; the general case of evaluate().
double run(const Expression& formula, Evaluation& at);

/// The value of a formula. Where it has none, `at.fault` says why; a value may also be not finite.
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

/// The value of a formula as a parameter: one that is not finite is a fault.
inline double finite_value(const Expression& formula, Evaluation& at) {
  double value = evaluate(formula, at);
  if (!std::isfinite(value)) at.fail(FormulaFault::not_finite, formula.place);
  return value;
}

/// A named number, or a named array of numbers.
struct Constant {
  std::string name;
  std::vector<double> values;  ///< one for a number
  bool array = false;
  std::uint16_t table = 0;  ///< which of the tables, for an array
};

/// The names known to a formula.
struct Scope {
  std::span<const std::string> variables;
  std::span<const Constant> constants;
};

/// A position in a text being read, and the first mistake found. After a mistake nothing more is read.
struct Cursor {
  std::string_view text;
  std::size_t at = 0;
  std::string mistake = {};
  std::size_t mistake_at = 0;

  bool failed() const { return !mistake.empty(); }
  void skip_blanks();
  /// Skips blanks and then `word`, if it is next.
  bool consume(std::string_view word);
  bool at_end() { return skip_blanks(), at >= text.size(); }
  /// Stores the first mistake only.
  void fail(std::string what, std::size_t where);
};

/// Reads one formula and stops after it. `=` and `==` both compare.
Expression read_expression(Cursor& reader, const Scope& scope);

/// Whether a text is a valid name of a parameter or constant: letters, digits and `_`, no digit first.
bool is_identifier(std::string_view name);

/// Reads an identifier after blanks; empty where there is none.
std::string_view consume_identifier(Cursor& reader);

}  // namespace frond
