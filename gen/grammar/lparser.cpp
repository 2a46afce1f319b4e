#include <fmt/format.h>

#include "grammar/import.h"
#include "grammar/import_text.h"

namespace frond {

namespace {

using namespace import_text;

/// What a sign of LParser is called here; `bare` without a parameter, `given` before one.
struct Sign {
  char sign;
  std::string_view bare, given;
};

constexpr Sign kSigns[] = {
    {'<', "\\", "\\"},      {'>', "/", "/"},         {'%', "/(180)", "/(180)"}, {'~', "@~", "@~"},
    {'"', "\"(1.1)", "\""}, {'\'', "\"(0.9)", "\""}, {';', "@a(1.1)", "@a"},    {':', "@a(0.9)", "@a"},
    {'?', "@w(1.4)", "@w"}, {'!', "@w(0.7)", "@w"},
};

/// A word of LParser in our alphabet. Letters stay and are given their meaning by interpretation.
std::string word_of(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    bool given = i + 1 < text.size() && text[i + 1] == '(';
    const Sign* found = nullptr;
    for (const Sign& sign : kSigns)
      if (sign.sign == text[i]) found = &sign;
    if (found)
      out += given ? found->given : found->bare;
    else
      out += text[i];
    if (!given || !found) continue;
    std::size_t close = std::min(text.find(')', i), text.size() - 1);
    if (text[i] != '%') out += text.substr(i + 1, close - i);
    i = close;
  }
  return out;
}

/// The data lines, without `#` comments, up to the `@` that ends the object.
std::vector<Line> data_of(std::string_view text) {
  std::vector<Line> data;
  for (Line line : lines_of(text)) {
    line.text = trim(line.text.substr(0, line.text.find('#')));
    if (line.text.starts_with('@')) break;
    if (!line.text.empty()) data.push_back(line);
  }
  return data;
}

}  // namespace

Result<Import> import_lparser(std::string_view text) {
  std::vector<Line> data = data_of(text);
  if (data.size() < 5)
    return Error{"", "an LParser file has depth, angle, thickness, axiom and rules; some are missing"};
  std::optional<double> depth = number(data[0].text), angle = number(data[1].text),
                        thickness = number(data[2].text);
  if (!depth || !angle || !thickness)
    return Error{fmt::format("line {}", data[0].number), "depth, angle and thickness are numbers"};
  Import import;
  GrammarText& g = import.grammar;
  Errors errors;
  take_count(g.steps, depth, kMostSteps, data[0], errors);
  if (!errors.empty()) return errors;
  g.angle = *angle;
  g.width = *thickness / 100;  // a share of the step, which is 1
  g.axiom = word_of(data[3].text);
  for (std::size_t i = 4; i < data.size(); ++i) {
    std::string_view line = data[i].text;
    std::size_t equals = line.find('=');
    if (equals == line.npos || equals == 0) {
      errors.push_back({fmt::format("line {}", data[i].number), fmt::format("`{}` is no rule `A=…`", line)});
      continue;
    }
    g.rules.push_back({fmt::format("{} -> {}", word_of(trim(line.substr(0, equals))),
                                   word_of(trim(line.substr(equals + 1)))),
                       GrammarText::kUnlimited, fmt::format("line {}", data[i].number)});
    if (line.substr(equals).find('t') != line.npos)
      errors.push_back({fmt::format("line {}", data[i].number),
                        "`t` bends by LParser's own gravity, which is not known here; take it out and give "
                        "`tropism`, which holds for every segment"});
  }
  if (!errors.empty()) return errors;
  for (std::string_view rule :
       {"Z -> \"(0.5)F\"(2)", "z -> \"(0.5)f\"(2)", "Z(l) -> F(l)", "z(l) -> f(l)", "c -> '", "c(n) -> '(n)"})
    g.interpretation.push_back({std::string(rule), GrammarText::kUnlimited, "the alphabet of LParser"});
  return import;
}

}  // namespace frond
