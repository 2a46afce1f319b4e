#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/grammar.h"

namespace frond {

/// Parses rules and axioms into modules and gives every name with its number of parameters an id.
class ModuleReader {
 public:
  explicit ModuleReader(Grammar& grammar) : grammar_(grammar) {}

  /// The constants known so far.
  std::vector<Constant> constants;

  /// Start of each module read last, in its text.
  std::vector<std::size_t> places;

  /// Id of a name with that number of parameters; new if unknown. Fails beyond 256 ids.
  SymbolId id(std::string_view name, int arity, Cursor& reader);

  /// Modules with formulas as parameters, up to the end of the text: an axiom or a successor. Every branch
  /// that starts in it ends in it; only the drawing of a `bracket` starts a branch more than it ends, or one
  /// fewer.
  void read_modules(Cursor& reader, std::span<const std::string> variables, std::vector<SymbolId>& modules,
                    std::vector<Expression>& arguments, std::string_view bracket = {});

  /// Modules with names as parameters, up to the end of the text: a predecessor or a context.
  void read_pattern(Cursor& reader, std::vector<std::string>& variables, std::vector<SymbolId>& modules);

  /// The name of the next module; empty at the end.
  std::string_view consume_name(Cursor& reader) const;

 private:
  Grammar& grammar_;
};

/// A rule split into parts; each keeps its position in the whole text.
struct RuleParts {
  struct Part {
    std::size_t begin = 0, end = 0;
  };
  Part left, predecessor, right, condition, weight, successor;
};

/// Finds the arrow, the context signs, the condition and the weight of a rule.
std::optional<RuleParts> split_rule(Cursor& reader);

/// A reader's mistake as a message that shows the position.
Error complaint(const Cursor& reader, std::string_view where);

}  // namespace frond
