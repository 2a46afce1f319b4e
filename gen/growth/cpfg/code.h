#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cpfg/curves.h"

// A grammar of cpfg, compiled: trees of formulas and statements in flat arrays, referred to by index, and
// L-systems of productions. -1 stands for what is left out.

namespace frond::cpfg {

enum class FormulaKind : std::uint8_t {
  number,
  string,
  formal,
  local,
  variable,
  element,
  negate,
  negation,
  operation,
  both,
  either,
  choice,
  call
};

/// A node of a formula. `a`, `b` and `c` are nodes, or what the kind says.
struct FormulaNode {
  FormulaKind kind;
  int a = -1;  ///< formal, local, variable: its slot. element: the array. call: the function. string: index
  int b = -1;  ///< element, call: the first argument in Code::lists
  int c = -1;  ///< element, call: how many arguments. operation, both, either: the operator
  double value = 0;  ///< number: its value
  int line = 0;      ///< call: the index of its place in Code::places
};

struct Run;
struct FunctionCall;

struct FormulaFunction {
  std::string_view name;
  int least, most;                       ///< how many arguments
  double (*value)(const FunctionCall&);  ///< nullptr: it has no effect
  std::string_view refused = {};         ///< what it would need that is not there; empty: nothing
};
std::span<const FormulaFunction> formula_functions();

/// An operator between two values. All bind to the left, `^` too.
struct BinaryOperator {
  std::string_view sign;
  int strength;
  double (*value)(Run&, double, double);      ///< of an operation
  FormulaKind kind = FormulaKind::operation;  ///< or both, either
};
/// Longer signs first.
std::span<const BinaryOperator> binary_operators();

enum class StatementKind : std::uint8_t {
  assign_local,
  assign_formal,
  assign_variable,
  assign_element,
  call,
  condition,
  loop,
  loop_after
};

struct Statement {
  StatementKind kind;
  int target = -1;            ///< a slot, or the node of an element
  int formula = -1;           ///< the value, the condition or the call
  int body = -1, other = -1;  ///< blocks
  int place = -1;             ///< of a loop: where it stands, in Code::places
};

/// A module of a pattern. Its formal parameters have the next `count` places in the frame, from `first` on.
struct PatternModule {
  char symbol;
  int count = 0, first = 0;
};

/// A module of an axiom or a successor: its formulas stand in Code::lists.
struct ModuleText {
  char symbol;
  int count = 0, first = 0;
};

struct CpfgProduction {
  std::vector<PatternModule> left, predecessor, right;
  int formals = 0;
  int before = -1, condition = -1, after = -1, weight = -1;
  std::vector<ModuleText> successor;
  std::string where;
};

/// Productions of one kind, found by the first letter of their predecessor, in the order of the file.
struct ProductionSet {
  std::vector<CpfgProduction> productions;
  std::array<std::vector<int>, 256> of_symbol;
  int depth = 1;  ///< of decomposition and homomorphism
  bool has_seed = false;
  std::int64_t seed = 0;
};

/// A variable's values: one, or those of an array, from `slot` on.
struct CpfgArray {
  std::string name;
  int slot = 0;
  std::vector<int> sizes;
  std::vector<int> initial;  ///< formulas
};

/// A name of an enclosing L-system.
struct ExternalName {
  std::string name;
  int slot = 0, count = 1;
};

struct CpfgSystem {
  int number = 1;
  int length = -1;  ///< the formula of its derivation length
  bool ring = false;
  std::array<bool, 256> ignored{};
  int start = -1, start_each = -1, end = -1, end_each = -1;  ///< blocks
  std::map<std::string, int, std::less<>> variables;         ///< their slots
  std::vector<CpfgArray> arrays;
  std::vector<ExternalName> externals;
  int slots = 0;
  bool has_axiom = false;
  std::vector<ModuleText> axiom;
  ProductionSet rules, decomposition, homomorphism;
};

/// Each L-system has these two first: its derivation length and the step being made.
constexpr int kLengthSlot = 0, kStepSlot = 1;

struct Code {
  std::vector<FormulaNode> formulas;
  std::vector<int> lists;  ///< runs of nodes
  std::vector<std::vector<Statement>> blocks;
  std::vector<std::string> strings;
  std::vector<std::string> places;  ///< where calls and loops stand
  std::vector<CpfgSystem> systems;
  int locals = 0;   ///< values that productions keep for themselves
  int formals = 0;  ///< the most that a production has
  std::vector<FunctionTable> functions;
  std::vector<CurveTable> curves;
};

/// A string is a parameter, too: a number that is none, which carries the string's index also when it is
/// rounded to 32 bits.
double string_number(int index);
/// The index of the string that a parameter stands for; -1 where it is a number.
int string_index(float value);

}  // namespace frond::cpfg
