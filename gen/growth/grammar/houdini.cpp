#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "core/text.h"
#include "grammar/houdini_words.h"
#include "grammar/import.h"
#include "grammar/import_text.h"

namespace frond {

namespace {

using namespace import_text;

/// A rule in our words, in parts.
struct HoudiniRule {
  std::string head, predecessor, condition, weight, successor;
  std::string kept;  ///< what the predecessor becomes where probabilities leave it as it is
  Line line;
  bool position = false, age = false;  ///< it uses the turtle's position, the age of its symbol
};

/// The numbers of the node under its labels and its internal names.
struct NodeNumber {
  std::array<std::string_view, 3> names;
  double GrammarText::*value;
};
constexpr NodeNumber kNumbers[] = {
    {{"angle", "angleinit"}, &GrammarText::angle},
    {{"anglescale"}, &GrammarText::angle_scale},
    {{"stepsize", "stepinit"}, &GrammarText::length},
    {{"stepsizescale", "stepscale"}, &GrammarText::length_scale},
    {{"thickness", "thickinit"}, &GrammarText::width},
    {{"thicknessscale", "thickscale"}, &GrammarText::width_scale},
};

/// What a bare symbol takes from the node.
struct Scale {
  std::string_view symbols, name;
  double GrammarText::*value;
};
constexpr Scale kScales[] = {{"\"_", "stepscale", &GrammarText::length_scale},
                             {"!?", "thickscale", &GrammarText::width_scale},
                             {";@", "anglescale", &GrammarText::angle_scale}};

/// Values that say how meshes are made, or that others here replace; with blanks between them.
constexpr std::string_view kIgnored =
    "type rows columns cols tension branchblend smooth contangl contlength contwidth inc continuousangles "
    "continuouslength docolor applycolor uvincrement groupprefix grpprefix continuouswidth colormap "
    "imagefile pointwidth dotexture vertinc pictop";

/// `Step Size` and `step_size` are one name.
std::string plain_name(std::string_view name) {
  std::string plain;
  for (char c : name)
    if (c != ' ' && c != '_') plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return plain;
}

/// Where the successor of `head = successor : probability` begins: behind the last single `=`; those of
/// conditions come before.
std::size_t last_equals(std::string_view line) {
  std::size_t equals = line.npos;
  int depth = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '(') ++depth;
    if (line[i] == ')') --depth;
    bool doubled = line.substr(i, 2) == "==" ||
                   (i > 0 && std::string_view("=<>!").find(line[i - 1]) != std::string_view::npos);
    if (depth == 0 && line[i] == '=' && !doubled) equals = i;
  }
  return equals;
}

std::string module_text(char symbol, std::string_view inside) {
  return inside.empty() ? std::string(1, symbol) : fmt::format("{}({})", symbol, inside);
}

class HoudiniReader {
 public:
  Result<GrammarText> read(std::string_view text) {
    g_.dialect = Dialect::houdini;
    g_.angle = 28;
    g_.length_scale = g_.width_scale = 0.5;
    g_.axiom.clear();
    g_.symbols = {"g"};
    std::vector<Line> lines = lines_of(text);
    std::erase_if(lines, [](const Line& line) { return line.text.starts_with('#'); });
    for (const Line& line : lines)
      if (std::optional<Error> odd = odd_sign(line)) errors_.push_back(std::move(*odd));
    if (!errors_.empty()) return std::move(errors_);
    for (const Line& line : lines)
      if (!read_setting(line)) read_rule(line);
    if (rules_.empty()) return Error{"", "there is no rule `A=…`; this is not a Houdini rule list"};
    if (g_.axiom.empty()) fail({}, "there is no `premise: …`");
    add_named_constants();
    tell();
    finish();
    if (!errors_.empty()) return std::move(errors_);
    return std::move(g_);
  }

 private:
  void fail(const Line& line, std::string what) {
    errors_.push_back({line.number > 0 ? place_in(line, line.text) : "", std::move(what)});
  }
  void note(std::string what) { g_.notes.push_back({"file", std::move(what)}); }
  bool given(std::string_view name) const { return std::ranges::find(given_, name) != given_.end(); }

  /// Reads a line `name: value`; false where it is none.
  bool read_setting(const Line& line) {
    std::size_t colon = line.text.find(':');
    if (colon == line.text.npos || line.text.substr(0, colon).find_first_of("=<>(") != line.text.npos)
      return false;
    std::string_view label = trim(line.text.substr(0, colon)), value = trim(line.text.substr(colon + 1));
    std::string name = plain_name(label);
    std::optional<double> number = import_text::number(value);
    if (name == "premise" || name == "axiom") {
      g_.axiom = words_.word(value, {});
      if (words_.takes_position || words_.takes_age)
        fail(line, "the premise cannot use x, y, z and g, which are 0 there");
      return fail_words(line), true;
    }
    if (name == "ignore" || name == "contextignore") return g_.ignore = value, true;
    if (std::ranges::count(split(kIgnored, ' '), name))
      return note(fmt::format("`{}` has no effect here", label)), true;
    if (name == "generations") return read_steps(g_, number, line, errors_), true;
    if (name == "seed" || name == "randomseed" || name == "randseed")
      return read_count(g_.seed, number, kMostSeed, line, errors_), true;
    if (name.size() == 4 && name.starts_with("var")) label = label.substr(label.size() - 1);
    if (!number) return false;
    if (label.size() == 1 && label.find_first_of("abcdefghijklmnopqrstuvwxyz") == 0)
      return g_.constants.emplace_back(label, value), true;
    return set_number(name, *number);
  }

  bool set_number(const std::string& name, double value) {
    for (const NodeNumber& known : kNumbers) {
      if (name.empty() || std::ranges::count(known.names, name) == 0) continue;
      g_.*known.value = value;
      given_.emplace_back(known.names[1].empty() ? known.names[0] : known.names[1]);
      return true;
    }
    if (name == "gravity") return gravity_ = value, true;
    if (name != "randomscale" && name != "randscale") return false;
    random_scale_ = value / 100;
    return true;
  }

  void fail_words(const Line& line) {
    for (HoudiniWords::Refusal& fault : words_.release_faults())
      errors_.push_back({place_in(line, fault.where), std::move(fault.what)});
  }

  void read_rule(const Line& line) {
    std::size_t equals = last_equals(line.text);
    if (equals == line.text.npos)
      return fail(line, fmt::format("`{}` is neither a rule `A=…` nor a value of the node", line.text));
    std::string_view head = trim(line.text.substr(0, equals)), successor = trim(line.text.substr(equals + 1));
    HoudiniRule rule;
    rule.line = line;
    std::size_t colon = head.find(':'), last = last_outside(successor, ':');
    rule.head = trim(head.substr(0, colon));
    std::size_t less = rule.head.find('<'), greater = rule.head.find('>');
    std::size_t begin = less == rule.head.npos ? 0 : less + 1;
    rule.predecessor = trim(std::string_view(rule.head).substr(begin, greater - begin));
    std::vector<std::string> names = parameters_in(rule.head);
    words_.takes_position = words_.takes_age = false;
    if (colon != head.npos) rule.condition = words_.formula(trim(head.substr(colon + 1)), names);
    if (last != successor.npos) rule.weight = words_.formula(trim(successor.substr(last + 1)), names);
    rule.successor = words_.word(trim(successor.substr(0, last)), names);
    rule.position = words_.takes_position, rule.age = words_.takes_age;
    rule.kept = rule.predecessor;
    if (rule.predecessor.empty()) fail(line, "there is no symbol before the `=`");
    fail_words(line);
    rules_.push_back(std::move(rule));
  }

  /// Values of the node that formulas use by name.
  void add_named_constants() {
    auto add = [&](char name, std::optional<double> value) {
      auto known = [&](const auto& constant) { return constant.first == std::string(1, name); };
      if (words_.names.find(name) != std::string::npos && value && std::ranges::none_of(g_.constants, known))
        g_.constants.emplace_back(std::string(1, name), fmt::format("{}", *value));
    };
    add('a', g_.angle);
    add('T', gravity_);
  }

  /// Notes of what is left out or taken for granted.
  void tell() {
    auto uses = [&](char symbol) { return words_.used.find(symbol) != std::string::npos; };
    for (const Scale& scale : kScales)
      if (words_.bare.find_first_of(scale.symbols) != std::string::npos && !given(scale.name))
        note(fmt::format("`{}` is not given; {} is taken", scale.name, g_.*scale.value));
    if (uses('g')) note("`g` starts a group, which has no effect here");
    if (words_.colors) note("amounts of `'` and `#` are left out: each goes on to the next colour");
    if (words_.stamps) note("parameters of J, K and M after the first, which stamp a leaf, are left out");
    if (uses('T'))
      note(
          "`T(g)` turns by g radians times the sine of the angle to the ground; how far Houdini turns is "
          "not published");
    if (words_.bare.find('T') == std::string::npos) return;
    if (!gravity_) return fail({}, "`T` takes the gravity of the node, which is not given; add `gravity: …`");
    g_.interpretation.push_back(
        {fmt::format("T -> T({})", *gravity_), GrammarText::kUnlimited, "the gravity of the node"});
  }

  void finish() {
    g_.length_jitter = random_scale_;
    g_.angle_jitter = random_scale_ * std::abs(g_.angle);
    fill_parameters();
    if (std::ranges::any_of(rules_, [](const HoudiniRule& rule) { return rule.age; })) keep_ages();
    if (std::ranges::any_of(rules_, [](const HoudiniRule& rule) { return rule.position; })) ask_position();
    for (std::size_t i = 0; i < rules_.size(); ++i) {
      const HoudiniRule& rule = rules_[i];
      std::string head = rule.head + condition_of(rule), weight = rule.weight;
      if (!weight.empty()) weight = fmt::format("({})", weight);
      add(fmt::format("{} ->{} {}", head, weight, rule.successor), rule.line.number);
      if (std::string rest = rest_after(i); !rest.empty())
        add(fmt::format("{} ->({}) {}", head, rest, rule.kept), rule.line.number);
    }
    for (std::string& rule : ages_) g_.rules.push_back({std::move(rule), GrammarText::kUnlimited, "ages"});
    for (std::string& rule : answers_)
      g_.rules.push_back({std::move(rule), GrammarText::kUnlimited, "the turtle's position"});
  }

  void add(std::string rule, int line) {
    g_.rules.push_back({std::move(rule), GrammarText::kUnlimited, fmt::format("line {}", line)});
  }

  static std::string condition_of(const HoudiniRule& rule) {
    return rule.condition.empty() ? "" : " : " + rule.condition;
  }

  /// Probabilities of one case that add up to less than 1 leave the symbol as it is now and then: that weight
  /// behind the last rule of the case, or nothing.
  std::string rest_after(std::size_t last) const {
    auto same = [&](const HoudiniRule& other) {
      return !other.weight.empty() && other.head == rules_[last].head &&
             other.condition == rules_[last].condition;
    };
    if (rules_[last].weight.empty() || std::any_of(rules_.begin() + last + 1, rules_.end(), same)) return {};
    std::optional<double> total = 0;
    std::string sum;
    for (const HoudiniRule& rule : rules_) {
      if (!same(rule)) continue;
      std::optional<double> share = number(rule.weight);
      total = total && share ? std::optional(*total + *share) : std::nullopt;
      sum += fmt::format("-({})", rule.weight);
    }
    return total && *total > 1 - 1e-9 ? "" : fmt::format("max(0,1{})", sum);
  }

  /// Changes the modules of the premise and of all successors.
  void change_words(const std::function<std::string(char symbol, std::string_view inside)>& change) {
    g_.axiom = each_module(g_.axiom, change);
    for (HoudiniRule& rule : rules_) rule.successor = each_module(rule.successor, change);
  }

  /// Parameters that a word leaves out at the end are 0, where the rules of its symbol have them.
  void fill_parameters() {
    std::map<char, std::set<std::size_t>> counts;
    for (const HoudiniRule& rule : rules_)
      if (!rule.predecessor.empty() && draws_nothing(rule.predecessor[0]))
        counts[rule.predecessor[0]].insert(parameters_in(rule.predecessor).size());
    change_words([&](char symbol, std::string_view inside) {
      auto known = counts.find(symbol);
      std::size_t given = inside.empty() ? 0 : parts_of(inside).size();
      std::string filled(inside);
      if (known != counts.end() && !known->second.contains(given))
        for (std::size_t most = *known->second.rbegin(); given < most; ++given)
          filled += filled.empty() ? "0" : ",0";
      return module_text(symbol, filled);
    });
  }

  /// Symbols whose rules use `g` have their age, in steps, as a last parameter.
  void keep_ages() {
    note("`g` is the age of a symbol: the steps since it appeared, 0 in the first that could rewrite it");
    std::string symbols;
    for (const HoudiniRule& rule : rules_)
      if (rule.age) symbols += rule.predecessor[0];
    auto aged = [&](std::string_view module, std::string_view age) {
      return each_module(module, [&](char symbol, std::string_view inside) {
        std::string_view comma = inside.empty() ? "" : ",";
        return fmt::format("{}({}{}{})", symbol, inside, comma, age);
      });
    };
    std::map<std::string, bool> kept;  // rules by which a symbol grows older, and whether any comes to that
    for (HoudiniRule& rule : rules_) {
      if (rule.head.find_first_of(symbols) == rule.head.npos) continue;
      if (rule.head != rule.predecessor) fail(rule.line, "g cannot be had in a grammar with contexts");
      rule.kept = aged(rule.predecessor, "g_+1");
      rule.head = rule.predecessor = aged(rule.predecessor, "g_");
      bool& stays =
          kept.try_emplace(fmt::format("{} -> {}", rule.predecessor, rule.kept), true).first->second;
      stays = stays && !rule.condition.empty();
    }
    change_words([&](char symbol, std::string_view inside) {
      std::string module = module_text(symbol, inside);
      return symbols.find(symbol) == symbols.npos ? module : aged(module, "0");
    });
    for (const auto& [rule, stays] : kept)
      if (stays) ages_.push_back(rule);
  }

  /// The turtle answers questions where symbols stand whose rules use its position.
  void ask_position() {
    std::vector<std::string> kept;
    std::string symbols;
    for (HoudiniRule& rule : rules_) {
      if (rule.head != rule.predecessor)
        fail(rule.line, "x, y and z cannot be had in a grammar with contexts");
      if (!rule.position) continue;
      symbols += rule.predecessor[0];
      std::string symbol(1, rule.predecessor[0]);
      for (std::size_t i = 0, n = parameters_in(rule.predecessor).size(); i < n; ++i)
        symbol += fmt::format("{}p{}{}", i == 0 ? "(" : ",", i, i + 1 == n ? ")" : "");
      std::string keep = fmt::format("?P(x_,y_,z_) > {} -> ?P(x_,y_,z_)", symbol);
      if (std::ranges::find(kept, keep) == kept.end()) kept.push_back(keep);
    }
    change_words([&](char symbol, std::string_view inside) {
      std::string module = module_text(symbol, inside);
      return (symbols.find(symbol) == symbols.npos ? "" : "?P(0,0,0)") + module;
    });
    for (HoudiniRule& rule : rules_)
      if (rule.position) rule.head = "?P(x_,y_,z_) < " + rule.head;
    kept.emplace_back("?P(x_,y_,z_) -> *");
    answers_ = std::move(kept);
    g_.symbols.emplace_back("?P");
  }

  GrammarText g_;
  HoudiniWords words_;
  std::vector<HoudiniRule> rules_;
  std::vector<std::string> given_;           ///< internal names of what the list gives
  std::vector<std::string> ages_, answers_;  ///< rules that count ages; of the questions for the position
  std::optional<double> gravity_;
  double random_scale_ = 0;
  Errors errors_;
};

}  // namespace

Result<GrammarText> import_houdini(std::string_view text) { return HoudiniReader().read(text); }

}  // namespace frond
