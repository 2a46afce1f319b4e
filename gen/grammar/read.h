#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/grammar.h"

namespace frond {

/// Turns the text of rules and axioms into modules, giving every name with its number of parameters an id.
class ModuleReader {
 public:
  explicit ModuleReader(Grammar& grammar) : grammar_(grammar) {}

  /// The constants as far as they are known.
  std::vector<Constant> constants;

  /// Where in its text each of the modules read last begins.
  std::vector<std::size_t> places;

  /// Id of a name with so many parameters; a new one where it is not known yet. Fails when there are 256 of
  /// them.
  SymbolId id(std::string_view name, int arity, Cursor& reader);

  /// Modules with formulas as parameters, to the end of the text: an axiom or a successor.
  void read_modules(Cursor& reader, std::span<const std::string> variables, std::vector<SymbolId>& modules,
                    std::vector<Expression>& arguments);

  /// Modules with names as parameters, to the end of the text: a predecessor or a context.
  void read_pattern(Cursor& reader, std::vector<std::string>& variables, std::vector<SymbolId>& modules);

  /// The name of the module that stands next; empty at the end.
  std::string_view take_name(Cursor& reader) const;

 private:
  Grammar& grammar_;
};

/// A rule cut into its parts; each keeps its place in the whole text.
struct RuleParts {
  struct Part {
    std::size_t begin = 0, end = 0;
  };
  Part left, predecessor, right, condition, weight, successor;
};

/// Finds the arrow, the context signs, the condition and the weight of a rule.
std::optional<RuleParts> split_rule(Cursor& reader);

/// The mistake that a reader met, as a message that shows the place.
Error complaint(const Cursor& reader, std::string_view where);

}  // namespace frond
