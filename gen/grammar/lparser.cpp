#include <fmt/format.h>

#include <algorithm>

#include "grammar/import.h"
#include "grammar/import_text.h"

namespace frond {

namespace {

using namespace import_text;

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

class LParserReader {
 public:
  Result<GrammarText> read(std::string_view text) {
    grammar_.dialect = Dialect::lparser;
    grammar_.length_scale = 0.9;
    grammar_.width = 1;
    grammar_.symbols = {"_"};  // what forms that are delayed end in
    std::vector<Line> data = data_of(text);
    bool named = std::ranges::any_of(data, [](const Line& line) {
      return line.text.starts_with("axiom ") || line.text.starts_with("rule ");
    });
    if (named)
      for (const Line& line : data) read_named(line);
    else
      read_lines(data);
    if (errors_.empty() && !axiom_) fail({}, "there is no axiom");
    if (errors_.empty() && grammar_.rules.empty()) fail({}, "there is no rule `A=…`");
    if (!errors_.empty()) return std::move(errors_);
    return std::move(grammar_);
  }

 private:
  void fail(const Line& line, std::string what) {
    errors_.push_back({line.number > 0 ? fmt::format("line {}", line.number) : "", std::move(what)});
  }
  void note(const Line& line, std::string what) {
    grammar_.notes.push_back({fmt::format("line {}", line.number), std::move(what)});
  }

  /// Up to version 4: depth, angle, thickness, axiom and rules, each on its line.
  void read_lines(const std::vector<Line>& data) {
    if (data.size() < 5)
      return fail({}, "an LParser file has depth, angle, thickness, axiom and rules; some are missing");
    grammar_.length = 100;  // in which lengths are given
    read_value("recursion", data[0].text, data[0]);
    read_value("angle", data[1].text, data[1]);
    read_value("thickness", data[2].text, data[2]);
    read_value("axiom", data[3].text, data[3]);
    for (std::size_t i = 4; i < data.size(); ++i) read_value("rule", data[i].text, data[i]);
  }

  /// Version 5: `keyword value`.
  void read_named(const Line& line) {
    std::size_t end = std::min(line.text.find_first_of(" \t"), line.text.size());
    read_value(line.text.substr(0, end), trim(line.text.substr(end)), line);
  }

  void read_value(std::string_view name, std::string_view value, const Line& line) {
    if (name == "axiom") return void(axiom_ = read_word(value, line, grammar_.axiom));
    if (name == "rule") return read_rule(value, line);
    for (std::string_view idle :
         {"min_thickness", "shape", "color", "poly_limit", "switch_yz", "trace", "no_wait"})
      if (name == idle) return note(line, fmt::format("`{}` has no effect here", name));
    std::optional<double> given = number(value);
    if (name == "recursion") return take_steps(grammar_, given, line, errors_);
    if (name != "angle" && name != "thickness" && name != "mutation")
      return fail(line, fmt::format("`{}` is no keyword of LParser; expected recursion, angle, thickness, "
                                    "mutation, axiom or rule",
                                    name));
    if (!given) return fail(line, fmt::format("`{}`: the {} is a number", value, name));
    if (name == "mutation") return take_count(grammar_.mutations, given, kMostMutations, line, errors_);
    if (name == "thickness" && !(*given > 0))
      return fail(line, fmt::format("`{}`: the thickness is more than 0", value));
    (name == "angle" ? grammar_.angle : grammar_.width) = name == "angle" ? *given : *given / 100;
  }

  void read_rule(std::string_view rule, const Line& line) {
    std::size_t equals = rule.find('=');
    std::string_view letter = trim(rule.substr(0, equals));
    if (equals == rule.npos || letter.size() != 1)
      return fail(line, fmt::format("`{}` is no rule `A=…`", rule));
    if (std::string_view("<>:()[]0123456789").find(letter[0]) != std::string_view::npos)
      return fail(line, fmt::format("`{}`: what this sign means cannot be rewritten here; give the rule a "
                                    "letter of its own",
                                    rule));
    std::string text = fmt::format("{} -> ", letter);
    if (!read_word(rule.substr(equals + 1), line, text)) return;
    for (const GrammarText::Rule& other : grammar_.rules)
      if (other.text[0] == letter[0])
        return note(line, fmt::format("`{}` is never used: the first rule of a letter counts", rule));
    grammar_.rules.push_back({text, GrammarText::kUnlimited, fmt::format("line {}", line.number)});
  }

  /// Adds a word, in which parameters are numbers and blanks do not count.
  bool read_word(std::string_view word, const Line& line, std::string& text) {
    if (&text == &grammar_.axiom) text.clear();
    for (std::size_t i = 0; i < word.size(); ++i) {
      if (word[i] == ' ' || word[i] == '\t') continue;
      std::size_t end = i + 1;
      if (word[i] == '(') {
        end = std::min(word.find(')', i), word.size() - 1) + 1;
        if (!number(word.substr(i + 1, std::max(end, i + 2) - i - 2)))
          return fail(line, fmt::format("`{}`: a parameter in ( ) is a number", word.substr(i, end - i))),
                 false;
      }
      text += word.substr(i, end - i);
      i = end - 1;
    }
    return true;
  }

  GrammarText grammar_;
  Errors errors_;
  bool axiom_ = false;
};

}  // namespace

Result<GrammarText> import_lparser(std::string_view text) { return LParserReader().read(text); }

}  // namespace frond
