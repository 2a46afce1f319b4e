#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/assets.h"
#include "core/result.h"
#include "core/vec.h"
#include "grammar/expression.h"
#include "grammar/guide.h"
#include "grammar/symbols.h"
#include "grammar/word.h"

namespace frond {

/// Limits on the size of a word, after which a derivation stops.
struct Limits {
  std::uint64_t modules = 200'000'000;
  std::uint64_t bytes = std::uint64_t{4} << 30;
};

/// A grammar as its author writes it.
struct GrammarText {
  enum class Mode { parallel, sequential };

  static constexpr int kUnlimited = std::numeric_limits<int>::max();

  /// `left < predecessor > right : condition ->(weight) successor`
  struct Rule {
    std::string text = {};
    int limit = kUnlimited;  ///< how often the rule may be used in a derivation
    std::string where = {};  ///< for messages: where the rule stands; empty: "rule 3"
  };

  FileName file;  ///< of another program, from which all that follows was taken; empty: none
  std::string axiom = "F";
  int steps = 1;
  double last_step = 1;       ///< 0..1: how far the last step has grown
  double angle = 45;          ///< degrees, of a turn that has no parameter
  double length = 1;          ///< of a segment that has no parameter
  double width = 0.1;         ///< diameter to begin with; of LParser: as a share of a segment's length
  double width_scale = 0.7;   ///< what a bare `!` multiplies the width by
  double length_scale = 1.1;  ///< what a bare `"` multiplies the length by
  double angle_scale = 0.9;   ///< what Houdini's and LParser's symbols multiply or divide the angle by
  double angle_jitter = 0;    ///< degrees: largest random change of each turn, plus or minus
  double length_jitter = 0;   ///< share: largest random change of each segment's length, plus or minus
  DVec3 tropism{0, -1, 0};    ///< the pull on every segment, used as it is given
  double elasticity = 0;      ///< bending of a segment toward the tropism: turned by e|H x T| radians
  std::vector<std::pair<std::string, std::string>> constants;  ///< name, formula or `[a, b, …]`
  std::vector<std::pair<std::string, double>> numbers;         ///< constants whose values are known
  std::vector<Rule> rules, decomposition, interpretation;
  int interpretation_depth = 1;  ///< recursion depth of interpretation rules
  Mode mode = Mode::parallel;
  std::string ignore;                ///< symbols that contexts skip
  std::string consider;              ///< if not empty: the only symbols that contexts see
  std::vector<std::string> symbols;  ///< names of more than one letter
  bool ring = false;                 ///< the word is circular: its ends are neighbours
  std::uint64_t seed = 1;
  Limits limits;  ///< of what may be derived
  Dialect dialect = Dialect::abop;
  DVec3 start{0};  ///< where the turtle starts
  DVec3 start_heading{0, 1, 0};
  GuideText guide;                       ///< what `?` follows
  std::vector<std::string> organs = {};  ///< names of shapes that are not turtle symbols
  std::string where = {};                ///< for messages: position of the grammar
  int mutations = 0;                     ///< of LParser: how often its rules are changed by chance
  Errors notes = {};                     ///< what of another program's file has no meaning here

  double growth() const { return steps - 1 + last_step; }
};

/// A name with its number of parameters: F and F(l) are two symbols.
struct Symbol {
  std::string name;
  int arity = 0;
  Act act = Act::none;
  bool context = true;  ///< whether contexts see it
};

/// Where a symbol is first produced: a rule or the axiom, its text and the position in it.
struct Making {
  std::string where, text;
  std::size_t at = 0;
};

/// One rule, compiled. The variables of its formulas are the parameters of the left context, the predecessor
/// and the right context, in the order written.
struct Production {
  SymbolId predecessor = 0;
  std::vector<SymbolId> left, right;  ///< right may hold brackets
  int variables = 0;                  ///< number of parameters in all
  bool conditional = false, weighted = false;
  Expression condition, weight;
  int limit = GrammarText::kUnlimited;
  std::vector<SymbolId> successor;
  std::vector<Expression> arguments;  ///< of all modules of the successor in order
  std::string where, text;            ///< for messages, as the places in the text that follow
  std::size_t place = 0;              ///< of the predecessor
  std::vector<std::size_t> left_places, right_places;  ///< of the modules of the contexts

  bool context_free() const { return left.empty() && right.empty(); }
  bool always() const {
    return context_free() && !conditional && !weighted && limit == GrammarText::kUnlimited;
  }
};

/// Rules in the order written, and for each symbol the rules that have it as predecessor.
struct RuleSet {
  std::vector<Production> rules;
  std::array<std::vector<std::uint16_t>, 256> of;

  bool empty() const { return rules.empty(); }
};

/// How far a module that goes forward takes the turtle, whose step is `step`.
inline double way_of(const Symbol& symbol, const double* parameters, double step, Dialect dialect) {
  bool half = goes_half(symbol.act) && (symbol.arity == 0 || dialect == Dialect::houdini);
  return (symbol.arity > 0 ? parameters[0] : step) * (half ? 0.5 : 1);
}

struct TurtleState;

/// The surroundings of a plant: answers a question `?E(what, …)` at the turtle's position by writing into its
/// parameters. Light, distances to surfaces, food and guides reach a grammar through it.
using Environment = std::function<void(const TurtleState&, std::span<double> parameters)>;

/// A grammar ready to derive. Plain data; made by compile().
struct Grammar {
  GrammarText text;
  std::vector<Symbol> symbols;  ///< at most 256
  std::vector<std::vector<double>> tables;
  RuleSet rules, decomposition, interpretation;
  Word axiom;
  Guide guide;  ///< empty also where the grammar has no `?`
  Errors warnings;
  Environment environment;  ///< may be empty: `?E` then keeps its parameters

  bool context_free = true;  ///< no rule has a context
  bool single = true;        ///< at most one rule per symbol, and it always applies
  bool stochastic = false;   ///< random numbers are drawn while deriving
  bool parametric = false;
  bool limited = false;  ///< some rule may be used a limited number of times
  bool cuts = false;     ///< `%` occurs
  bool queries = false;  ///< there are questions that the turtle answers between steps
  bool asks = false;     ///< some questions are for the environment

  SymbolId open = 0, close = 0;  ///< the brackets

  std::vector<std::optional<Making>> making;  ///< of each symbol
};

/// Checks and compiles a grammar. All mistakes are reported, each with its rule and place and what to do.
Result<Grammar> compile(const GrammarText& text);

/// `name(p1,p2)name…`, numbers with ten significant digits.
std::string text(const Grammar& grammar, const Word& word);

/// Number of occurrences of each name, in the order of the symbols, whatever parameters it has.
std::vector<std::pair<std::string, std::size_t>> counts(const Grammar& grammar, const Word& word);

}  // namespace frond
