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

/// What the thickness is taken to be where a file has none, as a share of a length.
constexpr double kWidthOfMusic = 0.1;

/// The word that a line begins with, in lower case.
std::string keyword_of(const Line& line) {
  std::string word(line.text.substr(0, std::min(line.text.find_first_of(" \t"), line.text.size())));
  for (char& c : word) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return word;
}

class LParserReader {
 public:
  Result<GrammarText> read(std::string_view text) {
    grammar_.dialect = Dialect::lparser;
    grammar_.length_scale = 0.9;
    grammar_.width = 1;
    grammar_.symbols = {"_"};  // what forms that are delayed end in
    std::vector<Line> data = data_of(text);
    for (const Line& line : data)
      if (std::optional<Error> odd = odd_sign(line)) errors_.push_back(std::move(*odd));
    if (!errors_.empty()) return std::move(errors_);
    bool named = std::ranges::any_of(data, [](const Line& line) {
      std::string word = keyword_of(line);
      return word == "axiom" || word == "rule";
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
  void fail(const Line& line, std::string what) { fail(line, line.text, std::move(what)); }
  void fail(const Line& line, std::string_view part, std::string what) {
    errors_.push_back({line.number > 0 ? place_in(line, part) : "", std::move(what)});
  }
  void note(const Line& line, std::string what) {
    grammar_.notes.push_back({fmt::format("line {}", line.number), std::move(what)});
  }

  /// Up to version 4: depth, angle, thickness, axiom and rules, each on its line.
  void read_lines(const std::vector<Line>& data) {
    bool music = data.size() > 3 && number(data[0].text) && number(data[1].text) && !number(data[2].text) &&
                 data[3].text.find('=') != std::string_view::npos;
    std::size_t at = 2;
    if (data.size() < (music ? 4 : 5))
      return fail({}, "an LParser file has depth, angle, thickness, axiom and rules; some are missing");
    grammar_.length = 100;  // in which lengths are given
    read_value("recursion", data[0].text, data[0]);
    read_value("angle", data[1].text, data[1]);
    if (music)
      grammar_.width = kWidthOfMusic,
      note(data[at], "a file of LMUSe, which has no thickness; what it plays has no effect here");
    else
      read_value("thickness", data[at].text, data[at]), ++at;
    read_value("axiom", data[at].text, data[at]);
    for (++at; at < data.size(); ++at) read_value("rule", data[at].text, data[at]);
  }

  /// Version 5: `keyword value`.
  void read_named(const Line& line) {
    std::string word = keyword_of(line);
    read_value(word, trim(line.text.substr(word.size())), line);
  }

  void read_value(std::string_view name, std::string_view value, const Line& line) {
    if (name == "axiom") return void(axiom_ = read_word(value, line, grammar_.axiom));
    if (name == "rule") return read_rule(value, line);
    for (std::string_view ignored :
         {"min_thickness", "shape", "color", "poly_limit", "switch_yz", "trace", "no_wait"})
      if (name == ignored) return note(line, fmt::format("`{}` has no effect here", name));
    if (name == "trope" || name == "rand")
      return note(line, fmt::format("`{}` of lsuss has no effect here; {}", name,
                                    name == "rand" ? "~(x) turns by up to x degrees"
                                                   : "t(x) says how far each t bends"));
    std::optional<double> given = number(value);
    if (name == "recursion") return read_steps(grammar_, given, line, errors_);
    if (name != "angle" && name != "thickness" && name != "mutation")
      return fail(line, fmt::format("`{}` is no keyword of LParser; expected recursion, angle, thickness, "
                                    "mutation, axiom or rule",
                                    name));
    if (!given) return fail(line, value, fmt::format("`{}`: the {} is a number", value, name));
    if (name == "mutation") return read_count(grammar_.mutations, given, kMostMutations, line, errors_);
    if (name == "thickness" && !(*given > 0))
      return fail(line, fmt::format("`{}`: the thickness is more than 0", value));
    (name == "angle" ? grammar_.angle : grammar_.width) = name == "angle" ? *given : *given / 100;
  }

  void read_rule(std::string_view rule, const Line& line) {
    std::size_t equals = rule.find('=');
    std::string_view letter = trim(rule.substr(0, equals));
    bool context = equals != rule.npos && letter.size() > 1 && letter.find_first_of("<>") != letter.npos;
    if (context)
      return fail(line, rule,
                  fmt::format("`{}`: a rule with contexts, as LMUSe has them, cannot be had here; write "
                              "it as a rule of a preset, `left < A > right -> …`",
                              rule));
    if (equals == rule.npos || letter.size() != 1)
      return fail(line, rule, fmt::format("`{}` is no rule `A=…`", rule));
    if (std::string_view("<>:()[]0123456789").find(letter[0]) != std::string_view::npos)
      return fail(line, letter,
                  fmt::format("`{}`: what this sign means cannot be rewritten here; give the rule a "
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
          return fail(line, word.substr(i),
                      fmt::format("`{}`: a parameter in ( ) is a number", word.substr(i, end - i))),
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
