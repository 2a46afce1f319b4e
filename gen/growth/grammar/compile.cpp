#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "grammar/lparser_rules.h"
#include "grammar/read.h"
#include "grammar/review.h"
#include "grammar/rewrite.h"

namespace frond {

namespace {

constexpr std::size_t kMostRules = 32767;     // that the indices of rules can tell apart
constexpr std::size_t kLongestContext = 256;  // modules

/// Whether a formula holds an instruction for which `test` is true.
template <class Test>
bool holds(const Expression& formula, const Test& test) {
  return std::any_of(formula.code.begin(), formula.code.end(),
                     [&](const Instruction& i) { return test(i.op); });
}

bool is_random(const Expression& formula) {
  return holds(formula, [](Op op) { return op == Op::rand || op == Op::nrand; });
}

/// Compiles one grammar; gathers what is wrong on the way.
class Compiler {
 public:
  explicit Compiler(GrammarText text) : modules_(grammar_) { grammar_.text = std::move(text); }

  Result<Grammar> compile() {
    Cursor none;
    grammar_.open = modules_.id("[", 0, none);
    grammar_.close = modules_.id("]", 0, none);
    check_numbers();
    std::size_t others = errors_.size();
    if (find_odd_signs(grammar_.text, errors_); errors_.size() > others) return errors_;
    read_constants();
    read_axiom();
    read_rules(grammar_.text.rules, grammar_.rules, "rule");
    read_rules(grammar_.text.decomposition, grammar_.decomposition, "decomposition rule");
    read_rules(grammar_.text.interpretation, grammar_.interpretation, "interpretation rule");
    keep_drawn_brackets();
    find_swelling(grammar_, errors_);
    read_visibility();
    read_guide();
    if (errors_.empty()) errors_ = find_endless(grammar_);
    if (!errors_.empty()) return errors_;
    grammar_.making.resize(grammar_.symbols.size());
    summarize();
    grammar_.warnings = review_warnings(grammar_);
    for (const RuleSet* set : {&grammar_.rules, &grammar_.decomposition, &grammar_.interpretation})
      find_shadowed(*set, grammar_.warnings);
    return std::move(grammar_);
  }

 private:
  void check_numbers() {
    const GrammarText& text = grammar_.text;
    auto need = [&](bool good, std::string_view name, double value, std::string_view range) {
      if (!good) errors_.push_back(error_at("", "`{}` is {}; it must be {}", name, value, range));
    };
    need(text.steps >= 0, "steps", text.steps, "0 or more");
    need(std::isfinite(text.angle), "angle", text.angle, "finite");
    need(std::isfinite(text.length), "length", text.length, "finite");
    need(text.width > 0 && std::isfinite(text.width), "width", text.width, "more than 0");
    need(text.width_scale > 0 && std::isfinite(text.width_scale), "width_scale", text.width_scale,
         "more than 0");
    need(text.length_scale > 0 && std::isfinite(text.length_scale), "length_scale", text.length_scale,
         "more than 0");
    need(text.interpretation_depth >= 0 && text.interpretation_depth <= 100, "interpretation_depth",
         text.interpretation_depth, "from 0 to 100");
    for (const std::string& symbol : text.symbols)
      if (symbol.empty() || symbol.find_first_of("()[], \t\n") != symbol.npos)
        errors_.push_back(
            error_at("symbols", "`{}` cannot be a symbol: no blanks, commas or brackets", symbol));
  }

  void note(const Cursor& reader, std::string_view where) {
    if (reader.failed()) errors_.push_back(complaint(reader, where));
  }

  /// Constants may use each other in any order: whatever can be read is read until nothing more can.
  void read_constants() {
    for (const auto& [name, value] : grammar_.text.numbers)
      modules_.constants.push_back({name, {value}, false, 0});
    const auto& texts = grammar_.text.constants;
    std::vector<bool> done(texts.size());
    for (std::size_t i = 0; i < texts.size(); ++i) {
      auto same = [&](const auto& other) { return other.first == texts[i].first; };
      if (!is_identifier(texts[i].first)) {
        errors_.push_back(
            error_at("constants", "`{}` is not a name; use letters, digits and _", texts[i].first));
        done[i] = true;
      } else if (std::find_if(texts.begin(), texts.end(), same) - texts.begin() <
                 static_cast<std::ptrdiff_t>(i)) {
        errors_.push_back(error_at("constants", "`{}` is given twice; remove one", texts[i].first));
        done[i] = true;
      }
    }
    for (bool progress = true; progress;) {
      progress = false;
      for (std::size_t i = 0; i < texts.size(); ++i) {
        Cursor reader{texts[i].second};
        if (!done[i] && read_constant(texts[i].first, reader)) done[i] = progress = true;
      }
    }
    for (std::size_t i = 0; i < texts.size(); ++i) {
      Cursor reader{texts[i].second};
      if (!done[i] && !read_constant(texts[i].first, reader))
        note(reader, fmt::format("constant `{}`", texts[i].first));
    }
  }

  bool read_constant(const std::string& name, Cursor& reader) {
    Constant constant{name, {}, reader.consume("["), 0};
    do {
      std::size_t start = reader.at;
      Expression formula = read_expression(reader, {{}, modules_.constants});
      if (!reader.failed() && formula.form != Expression::Form::constant)
        reader.fail("a constant is a number; use random numbers and the step in rules", start);
      if (!reader.failed() && !std::isfinite(formula.value))
        reader.fail("this is not a finite number", start);
      constant.values.push_back(formula.value);
    } while (constant.array && !reader.failed() && reader.consume(","));
    if (constant.array && !reader.failed() && !reader.consume("]"))
      reader.fail("a `]` is missing", reader.at);
    if (!reader.failed() && !reader.at_end()) reader.fail("this does not belong to the formula", reader.at);
    if (reader.failed()) return false;
    if (constant.array) {
      constant.table = static_cast<std::uint16_t>(grammar_.tables.size());
      grammar_.tables.push_back(constant.values);
    }
    modules_.constants.push_back(std::move(constant));
    return true;
  }

  void read_axiom() {
    Cursor reader{grammar_.text.axiom};
    std::vector<SymbolId> modules;
    std::vector<Expression> arguments;
    modules_.read_modules(reader, {}, modules, arguments);
    note(reader, "axiom");
    if (reader.failed()) return;
    note_making(modules, "axiom", reader.text);
    grammar_.axiom.symbols.assign(modules.begin(), modules.end());
    Evaluation at;
    at.tables = grammar_.tables;
    at.seed = Seed{grammar_.text.seed}.child("axiom");
    for (const Expression& argument : arguments) {
      grammar_.axiom.parameters.push_back(finite_value(argument, at));
      if (at.failed()) return errors_.push_back({"axiom", fault_in(grammar_.text.axiom, at)});
    }
  }

  void read_rules(const std::vector<GrammarText::Rule>& texts, RuleSet& set, std::string_view kind) {
    if (texts.size() > kMostRules)
      return errors_.push_back(error_at("", "{} {}s are more than can be told apart; {} are the most",
                                        texts.size(), kind, kMostRules));
    for (std::size_t i = 0; i < texts.size(); ++i) {
      Production rule;
      rule.where = texts[i].where.empty() ? fmt::format("{} {}", kind, i + 1) : texts[i].where;
      rule.text = texts[i].text;
      rule.limit = texts[i].limit;
      Cursor reader{texts[i].text};
      read_rule(reader, rule, &set == &grammar_.interpretation);
      if (rule.limit < 1)
        reader.fail(fmt::format("the limit is {}; it must be 1 or more, or left out", rule.limit), 0);
      if (&set != &grammar_.rules && rule.limit != GrammarText::kUnlimited)
        reader.fail(fmt::format("a {} has no limit of its own; remove `limit`", kind), 0);
      if (&set != &grammar_.rules && !rule.context_free())
        reader.fail(fmt::format("a {} has no context; remove `<` and `>`", kind), 0);
      note(reader, rule.where);
      if (reader.failed()) continue;
      set.of[rule.predecessor].push_back(static_cast<std::uint16_t>(set.rules.size()));
      set.rules.push_back(std::move(rule));
    }
  }

  /// Reads a part of a rule with `read(part)`, keeping the places of the whole rule.
  template <class Read>
  static void within(Cursor& reader, RuleParts::Part part, const Read& read) {
    if (reader.failed()) return;
    Cursor inner{reader.text.substr(0, part.end), part.begin, {}, 0};
    read(inner);
    if (inner.failed()) reader.fail(inner.mistake, inner.mistake_at);
  }

  void read_rule(Cursor& reader, Production& rule, bool drawn) {
    std::optional<RuleParts> parts = split_rule(reader);
    if (!parts) return;
    std::vector<std::string> variables;
    std::vector<SymbolId> predecessor;
    read_context(reader, parts->left, variables, rule.left);
    rule.left_places = modules_.places;
    within(reader, parts->predecessor,
           [&](Cursor& part) { modules_.read_pattern(part, variables, predecessor); });
    std::vector<std::size_t> places = modules_.places;
    read_context(reader, parts->right, variables, rule.right);
    rule.right_places = modules_.places;
    if (reader.failed()) return;
    if (predecessor.size() != 1)
      return reader.fail(
          "the predecessor is one module; put its neighbours into contexts, `left < one > right`, or write a "
          "model of cpfg (.l), whose productions may rewrite several at once",
          places.empty() ? parts->predecessor.begin : places.back());
    rule.place = places[0];
    rule.predecessor = predecessor[0];
    rule.variables = static_cast<int>(variables.size());
    std::string_view bracket = rule.predecessor == grammar_.open    ? "["
                               : rule.predecessor == grammar_.close ? "]"
                                                                    : "";
    if (!bracket.empty() && !drawn)
      return reader.fail(
          "brackets cannot be rewritten; an `interpretation` rule may say what the turtle draws for them",
          parts->predecessor.begin);
    if (!bracket.empty() && (parts->condition.end || parts->weight.end))
      return reader.fail("a bracket is always drawn alike; remove the condition and the weight",
                         parts->predecessor.begin);
    check_contexts(reader, *parts, rule);
    if (parts->condition.end) read_condition(reader, parts->condition, variables, rule);
    if (parts->weight.end) read_weight(reader, parts->weight, variables, rule);
    if (bracket.empty() && is_empty_word(reader.text.substr(parts->successor.begin))) return;
    within(reader, parts->successor, [&](Cursor& part) {
      modules_.read_modules(part, variables, rule.successor, rule.arguments, bracket);
    });
    if (!reader.failed()) note_making(rule.successor, rule.where, reader.text);
  }

  void note_making(const std::vector<SymbolId>& modules, const std::string& where, std::string_view text) {
    grammar_.making.resize(grammar_.symbols.size());
    for (std::size_t i = 0; i < modules.size(); ++i)
      if (std::optional<Making>& first = grammar_.making[modules[i]]; !first)
        first = Making{where, std::string(text), modules_.places[i]};
  }

  static bool is_empty_word(std::string_view text) {
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    while (!text.empty() && (text[0] == ' ' || text[0] == '\t')) text.remove_prefix(1);
    return text == "*" || text == "\u03b5";
  }

  void read_context(Cursor& reader, RuleParts::Part part, std::vector<std::string>& variables,
                    std::vector<SymbolId>& modules) {
    if (reader.failed() || part.end == 0 ||
        is_empty_word(reader.text.substr(part.begin, part.end - part.begin)))
      return;
    within(reader, part, [&](Cursor& inner) { modules_.read_pattern(inner, variables, modules); });
    if (modules.size() > kLongestContext)
      reader.fail(fmt::format("the context has {} modules; {} are the most", modules.size(), kLongestContext),
                  part.begin);
  }

  void check_contexts(Cursor& reader, const RuleParts& parts, const Production& rule) {
    for (SymbolId symbol : rule.left)
      if (symbol == grammar_.open || symbol == grammar_.close)
        reader.fail("the left context is the path to the root and has no brackets", parts.left.begin);
    int depth = 0;
    for (SymbolId symbol : rule.right) {
      depth += symbol == grammar_.open ? 1 : symbol == grammar_.close ? -1 : 0;
      if (depth < 0) break;
    }
    if (depth != 0) reader.fail("the brackets of the right context do not match", parts.right.begin);
  }

  void read_condition(Cursor& reader, RuleParts::Part part, const std::vector<std::string>& variables,
                      Production& rule) {
    if (is_empty_word(reader.text.substr(part.begin, part.end - part.begin))) return;
    within(reader, part, [&](Cursor& inner) {
      rule.condition = read_expression(inner, {variables, modules_.constants});
      if (!inner.failed() && !inner.at_end()) inner.fail("this does not belong to the condition", inner.at);
      bool fixed = !inner.failed() && rule.condition.form == Expression::Form::constant;
      if (fixed && !(rule.condition.value != 0))
        inner.fail("the condition is never true; remove the rule", part.begin);
      rule.conditional = !fixed;
    });
  }

  void read_weight(Cursor& reader, RuleParts::Part part, const std::vector<std::string>& variables,
                   Production& rule) {
    within(reader, part, [&](Cursor& inner) {
      rule.weight = read_expression(inner, {variables, modules_.constants});
      if (!inner.failed() && !inner.at_end()) inner.fail("this does not belong to the weight", inner.at);
      bool fixed = rule.weight.form == Expression::Form::constant;
      if (!inner.failed() && fixed && !(rule.weight.value >= 0 && std::isfinite(rule.weight.value)))
        inner.fail(fmt::format("the weight is {}; it must be 0 or more", rule.weight.value), part.begin);
      rule.weighted = true;
    });
  }

  /// Brackets that interpretation makes only start and end a branch: they are symbols of their own where
  /// others are drawn by rules.
  void keep_drawn_brackets() {
    RuleSet& set = grammar_.interpretation;
    for (SymbolId bracket : {grammar_.open, grammar_.close}) {
      if (set.of[bracket].empty()) continue;
      if (set.of[bracket].size() > 1) {
        const Production& other = set.rules[set.of[bracket][1]];
        errors_.push_back(in_rule(
            other, other.place,
            fmt::format("`{}` draws it in another way, but a bracket is always drawn alike", other.text)));
      }
      if (grammar_.symbols.size() == 256)
        return errors_.push_back({"", "more than 254 different symbols beside drawn brackets; use fewer"});
      auto plain = static_cast<SymbolId>(grammar_.symbols.size());
      grammar_.symbols.push_back(Symbol(grammar_.symbols[bracket]));
      for (Production& rule : set.rules) std::ranges::replace(rule.successor, bracket, plain);
    }
  }

  void read_visibility() {
    auto names_of = [&](const std::string& text, std::string_view where) {
      std::vector<std::string_view> names;
      Cursor reader{text};
      while (!reader.at_end() && !reader.failed()) names.push_back(modules_.consume_name(reader));
      note(reader, where);
      return names;
    };
    std::vector<std::string_view> ignore = names_of(grammar_.text.ignore, "ignore");
    std::vector<std::string_view> consider = names_of(grammar_.text.consider, "consider");
    auto has = [](const auto& names, std::string_view name) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    if (!ignore.empty() && !consider.empty())
      errors_.push_back({"consider", "give either `ignore` or `consider`, not both"});
    for (Symbol& symbol : grammar_.symbols)
      symbol.context = symbol.name != "[" && symbol.name != "]" && !has(ignore, symbol.name) &&
                       (consider.empty() || has(consider, symbol.name));
    for (const Production& rule : grammar_.rules.rules)
      for (auto [side, places] :
           {std::pair(&rule.left, &rule.left_places), {&rule.right, &rule.right_places}})
        for (std::size_t i = 0; i < side->size(); ++i)
          if (SymbolId id = (*side)[i];
              !grammar_.symbols[id].context && id != grammar_.open && id != grammar_.close)
            grammar_.text.notes.push_back(
                in_rule(rule, (*places)[i],
                        fmt::format("`{}` can never be used: its context has `{}`, which "
                                    "contexts look past; change `ignore` or the rule",
                                    rule.text, grammar_.symbols[id].name)));
  }

  void read_guide() {
    const GrammarText& text = grammar_.text;
    if (!(glm::length(text.start_heading) > 0)) errors_.push_back({"start", "the heading has no length"});
    if (text.guide.empty()) return;
    Result<Guide> guide = guide_of(text.guide);
    if (!guide) return errors_.insert(errors_.end(), guide.errors().begin(), guide.errors().end()), void();
    bool followed = std::any_of(grammar_.symbols.begin(), grammar_.symbols.end(),
                                [](const Symbol& symbol) { return symbol.act == Act::guide; });
    if (!followed)
      errors_.push_back(
          {"guide", "no rule has a `?`, at which the turtle follows the guide; add it or remove the guide"});
    grammar_.guide = std::move(*guide);
  }

  void summarize() {
    Grammar& g = grammar_;
    for (const Symbol& symbol : g.symbols) {
      g.parametric |= symbol.arity > 0;
      g.cuts |= symbol.act == Act::cut;
      g.asks |= symbol.act == Act::environment && symbol.arity > 0;
      g.queries |=
          (symbol.act == Act::query_position || symbol.act == Act::query_heading ||
           symbol.act == Act::query_up || symbol.act == Act::query_left || symbol.act == Act::environment) &&
          symbol.arity > 0;
    }
    for (const RuleSet* set : {&g.rules, &g.decomposition}) {
      for (const Production& rule : set->rules) {
        g.context_free &= rule.context_free();
        g.limited |= rule.limit != GrammarText::kUnlimited;
        g.single &= rule.always();
        g.stochastic |= rule.weighted || is_random(rule.condition);
        for (const Expression& argument : rule.arguments) g.stochastic |= is_random(argument);
      }
    }
    for (const auto& of : g.rules.of) g.single &= of.size() <= 1;
  }

  Grammar grammar_;
  ModuleReader modules_;
  Errors errors_;
};

}  // namespace

Result<Grammar> compile_plainly(GrammarText text) { return Compiler(std::move(text)).compile(); }

}  // namespace frond
