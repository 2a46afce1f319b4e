#include "grammar/import.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "grammar/import_text.h"

namespace frond {

namespace import_text {

std::string_view trim(std::string_view text) {
  std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  int number = 0;
  while (!text.empty()) {
    std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = trim(text.substr(0, end));
    text.remove_prefix(std::min(text.size(), end + 1));
    ++number;
    if (!line.empty()) lines.push_back({line, number});
  }
  return lines;
}

std::string without_comments(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    if (text.substr(i, 2) != "/*") {
      out += text[i++];
      continue;
    }
    std::size_t end = std::min(text.find("*/", i + 2), text.size());
    for (; i < end; ++i)
      if (text[i] == '\n') out += '\n';  // lines keep their numbers
    i = std::min(text.size(), i + 2);
  }
  return out;
}

std::optional<double> number(std::string_view text) {
  text = trim(text);
  double value = 0;
  auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

Error not_a_count(const Line& line, double most) {
  return {fmt::format("line {}", line.number),
          fmt::format("`{}`: expected a number from 0 to {:.0f}", line.text, most)};
}

std::size_t last_outside(std::string_view text, char sign) {
  int depth = 0;
  for (std::size_t i = text.size(); i-- > 0;) {
    if (text[i] == ')') ++depth;
    if (text[i] == '(') --depth;
    if (depth == 0 && text[i] == sign) return i;
  }
  return text.npos;
}

std::string replaced(std::string text, std::string_view name, std::string_view by) {
  auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  for (std::size_t at = text.find(name); at != text.npos; at = text.find(name, at)) {
    bool inside = at > 0 && letter(text[at - 1]);
    if (!inside) text.replace(at, name.size(), by);
    at += inside ? name.size() : by.size();
  }
  return text;
}

}  // namespace import_text

namespace {

using namespace import_text;

/// Reads a cpfg file line by line.
class CpfgReader {
 public:
  Result<Import> read(std::string_view text) {
    std::string clean = without_comments(text);
    for (const Line& line : lines_of(clean)) {
      if (!read_define(line.text) && !read_setting(line)) read_rule(line);
    }
    if (!errors_.empty()) return errors_;
    if (!has_axiom_) return Error{"", "there is no `axiom:`; this is not a cpfg file"};
    note("turning angle, line width and colours stand in the view file of cpfg: set `angle`, `width` here");
    return std::move(import_);
  }

 private:
  void note(std::string text) { import_.notes.push_back(std::move(text)); }

  bool read_define(std::string_view line) {
    if (!line.starts_with('#')) return false;
    bool define = line.starts_with("#define");
    std::string_view rest = trim(line.substr(define ? 7 : 1));
    std::size_t blank = std::min(rest.find_first_of(" \t"), rest.size());
    std::string_view name = rest.substr(0, blank), value = trim(rest.substr(blank));
    if (!define || !is_identifier(name) || value.empty()) {
      note(fmt::format("`{}` is left out: only `#define NAME formula` is read", line));
      return true;
    }
    import_.grammar.constants.emplace_back(name, formula(value));
    return true;
  }

  /// cpfg's functions under our names.
  static std::string formula(std::string_view text) {
    return replaced(replaced(std::string(text), "ran(", "rand(0,"), "nran(", "nrand(");
  }

  /// A formula of the constants so far.
  std::optional<double> value_of(std::string_view text) const {
    std::vector<Constant> known;
    auto value = [&](std::string_view formula) -> std::optional<double> {
      Cursor reader{formula};
      Expression read = read_expression(reader, {{}, known});
      if (reader.failed() || !reader.at_end() || read.form != Expression::Form::constant) return std::nullopt;
      return read.value;
    };
    for (const auto& [name, text_of] : import_.grammar.constants)
      if (std::optional<double> constant = value(text_of)) known.push_back({name, {*constant}});
    return value(text);
  }

  bool read_setting(const Line& whole) {
    std::string_view line = whole.text;
    GrammarText& g = import_.grammar;
    std::size_t colon = line.find(':');
    std::string_view name = trim(line.substr(0, colon));
    std::string_view value = colon == line.npos ? std::string_view() : trim(line.substr(colon + 1));
    std::vector<GrammarText::Rule>* before = rules_;
    if (name == "axiom" || name == "Axiom")
      g.axiom = formula(value), has_axiom_ = true;
    else if (name == "derivation length")
      take_count(g.steps, value_of(value), kMostSteps, whole, errors_);
    else if (name == "seed")
      take_count(g.seed, value_of(value), kMostSeed, whole, errors_);
    else if (name == "ignore")
      g.ignore = value;
    else if (name == "consider")
      g.consider = value;
    else if (name == "ring L-system")
      g.ring = value_of(value).value_or(0) != 0;
    else if (name == "decomposition")
      rules_ = &g.decomposition;
    else if (name == "homomorphism" || name == "interpretation")
      rules_ = &g.interpretation;
    else if (name == "production" || name == "productions")
      rules_ = &g.rules;
    else if (name == "maximum depth") {
      if (rules_ == &g.interpretation)
        take_count(g.interpretation_depth, value_of(value), kMostDepth, whole, errors_);
    } else if (name != "lsystem" && name != "endlsystem" && name != "Lsystem" &&
               !name.starts_with("warnings") && !name.starts_with("no warnings")) {
      for (std::string_view block : {"Start", "StartEach", "EndEach", "End"})
        if (name == block)
          return note(fmt::format("the block `{}` is left out: nothing is computed between steps", name)),
                 true;
      return false;
    }
    if (before != rules_ && rules_ == &g.interpretation) g.interpretation_depth = 1;
    return true;
  }

  /// `left < A > right : condition --> successor : weight`
  void read_rule(const Line& line) {
    std::size_t arrow = line.text.find("-->");
    if (arrow == line.text.npos)
      return note(fmt::format("line {}: `{}` is left out", line.number, line.text));
    std::string_view head = trim(line.text.substr(0, arrow)), successor = trim(line.text.substr(arrow + 3));
    if (head.find('{') != head.npos)
      return note(fmt::format("line {}: `{}` is left out: it computes in `{{ }}`", line.number, line.text));
    std::string weight;
    std::size_t colon = last_outside(successor, ':');
    if (colon != successor.npos) {
      weight = fmt::format("({})", formula(trim(successor.substr(colon + 1))));
      successor = trim(successor.substr(0, colon));
    }
    std::string rule = fmt::format("{} ->{} {}", formula(head), weight, formula(successor));
    rules_->push_back({rule, GrammarText::kUnlimited, fmt::format("line {}", line.number)});
    for (std::string_view sign : {"@P", "@D", "@S", "@T", "@#", "@!", "@;"})
      if (successor.find(sign) != successor.npos)
        note(fmt::format("line {}: `{}…` means nothing here", line.number, sign));
  }

  Import import_;
  std::vector<GrammarText::Rule>* rules_ = &import_.grammar.rules;
  bool has_axiom_ = false;
  Errors errors_;
};

/// Condition, successor and probability of a Houdini rule: `head = successor : probability`.
std::optional<std::string> houdini_rule(std::string_view line) {
  // The sign between head and successor is the last single `=`; those of conditions come before.
  std::size_t equals = line.npos;
  int depth = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '(') ++depth;
    if (line[i] == ')') --depth;
    bool doubled = line.substr(i, 2) == "==" ||
                   (i > 0 && std::string_view("=<>!").find(line[i - 1]) != std::string_view::npos);
    if (depth == 0 && line[i] == '=' && !doubled) equals = i;
  }
  if (equals == line.npos) return std::nullopt;
  std::string_view head = trim(line.substr(0, equals)), successor = trim(line.substr(equals + 1));
  std::string weight;
  std::size_t colon = last_outside(successor, ':');
  if (colon != successor.npos) {
    weight = fmt::format("({})", trim(successor.substr(colon + 1)));
    successor = trim(successor.substr(0, colon));
  }
  std::size_t condition = head.find(':');
  std::string where = condition == head.npos ? "" : fmt::format(" : {}", trim(head.substr(condition + 1)));
  return fmt::format("{}{} ->{} {}", trim(head.substr(0, condition)), where, weight, successor);
}

/// Takes a line `name: value` or `name = value`; false where it is none.
bool houdini_setting(const Line& whole, Import& import, Errors& errors) {
  std::string_view line = whole.text;
  std::size_t colon = line.find(':');
  std::string_view name = trim(line.substr(0, colon)),
                   value = colon == line.npos ? "" : trim(line.substr(colon + 1));
  GrammarText& g = import.grammar;
  std::optional<double> given = number(value);
  if (name == "premise" || name == "Premise" || name == "axiom")
    g.axiom = value;
  else if (name == "ignore" || name == "Context Ignore")
    g.ignore = value;
  else if (!given)
    return false;
  else if (name == "angle" || name == "Angle")
    g.angle = *given;
  else if (name == "generations" || name == "Generations")
    take_count(g.steps, given, kMostSteps, whole, errors);
  else if (name == "stepsize" || name == "Step Size")
    g.length = *given;
  else if (name == "thickness" || name == "Thickness")
    g.width = *given;
  else if (name == "stepscale" || name == "Step Size Scale")
    g.length_scale = *given;
  else if (name == "thickscale" || name == "Thickness Scale")
    g.width_scale = *given;
  else if (name == "seed" || name == "Random Seed")
    take_count(g.seed, given, kMostSeed, whole, errors);
  else if (is_identifier(name) && name.size() == 1)
    g.constants.emplace_back(name, value);
  else
    return false;
  return true;
}

}  // namespace

Result<Import> import_cpfg(std::string_view text) { return CpfgReader().read(text); }

Result<Import> import_houdini(std::string_view text) {
  Import import;
  import.grammar.dialect = Dialect::houdini;
  Errors errors;
  for (const Line& line : lines_of(text)) {
    if (line.text.starts_with('#') || houdini_setting(line, import, errors)) continue;
    if (std::optional<std::string> rule = houdini_rule(line.text)) {
      import.grammar.rules.push_back({*rule, GrammarText::kUnlimited, fmt::format("line {}", line.number)});
      for (char sign : {'J', 'K', 'M', 'T'})
        if (rule->find(sign) != rule->npos)
          import.notes.push_back(fmt::format(
              "line {}: `{}` is a symbol of its own here; Houdini {}", line.number, sign,
              sign == 'T' ? "applies gravity: use `tropism`" : "puts input geometry there: use `~`"));
    } else {
      import.notes.push_back(fmt::format("line {}: `{}` is left out", line.number, line.text));
    }
  }
  if (!errors.empty()) return errors;
  if (import.grammar.rules.empty())
    return Error{"", "there is no rule `A=…`; this is not a Houdini rule list"};
  return import;
}

Result<Import> import_grammar(std::string_view file_name, std::string_view text) {
  if (file_name.ends_with(".ls")) return import_lparser(text);
  if (file_name.ends_with(".l")) return import_cpfg(text);
  return import_houdini(text);
}

}  // namespace frond
