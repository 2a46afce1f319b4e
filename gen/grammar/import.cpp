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

}  // namespace import_text

namespace {

using namespace import_text;

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

Result<Import> import_houdini(std::string_view text) {
  Import import;
  import.grammar.dialect = Dialect::houdini;
  Errors errors;
  for (const Line& line : lines_of(text)) {
    if (line.text.starts_with('#') || houdini_setting(line, import, errors)) continue;
    if (std::optional<std::string> rule = houdini_rule(line.text)) {
      import.grammar.rules.push_back({*rule, GrammarText::kUnlimited, fmt::format("line {}", line.number)});
      std::string_view successor = std::string_view(*rule).substr(rule->find("->") + 2);
      if (successor.find('T') != successor.npos)
        errors.push_back({fmt::format("line {}", line.number),
                          "`T` bends by Houdini's own gravity, which is not known here; take it out and give "
                          "`tropism`, which holds for every segment"});
    } else {
      errors.push_back({fmt::format("line {}", line.number),
                        fmt::format("`{}` is neither a rule `A=…` nor a value of the node", line.text)});
    }
  }
  if (!errors.empty()) return errors;
  if (import.grammar.rules.empty())
    return Error{"", "there is no rule `A=…`; this is not a Houdini rule list"};
  return import;
}

Result<Import> import_grammar(std::string_view file_name, std::string_view text) {
  if (file_name.ends_with(".ls")) return import_lparser(text);
  return import_houdini(text);
}

}  // namespace frond
