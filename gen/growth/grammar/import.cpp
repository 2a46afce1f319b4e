#include "grammar/import.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "core/lookalike.h"
#include "core/plain_text.h"
#include "core/read_as.h"
#include "grammar/import_text.h"
#include "grammar/kind.h"

namespace frond {

namespace import_text {

std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  int number = 0;
  while (!text.empty()) {
    std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view whole = text.substr(0, end), line = trim(whole);
    text.remove_prefix(std::min(text.size(), end + 1));
    ++number;
    if (!line.empty()) lines.push_back({line, number, whole});
  }
  return lines;
}

std::optional<double> number(std::string_view text) {
  std::optional<double> value = read_as<double>(trim(text));
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::string place_in(const Line& line, std::string_view part) {
  std::string place = fmt::format("line {}", line.number);
  const char* begin = line.whole.data();
  std::less<const char*> before;
  if (before(part.data(), begin) || before(begin + line.whole.size(), part.data())) return place;
  return fmt::format("{}: column {}", place,
                     column_of(line.whole, static_cast<std::size_t>(part.data() - begin)));
}

std::optional<Error> odd_sign(const Line& line) {
  std::optional<Lookalike> odd = find_lookalike(line.text);
  if (!odd) return std::nullopt;
  return error_at(place_in(line, line.text.substr(odd->at)), "{} is not {}, which is meant; write that",
                  odd->name, odd->meant);
}

Error not_a_count(const Line& line, double most) {
  return error_at(place_in(line, line.text), "`{}`: expected a number from 0 to {:.0f}", line.text, most);
}

void read_steps(GrammarText& grammar, std::optional<double> given, const Line& line, Errors& errors) {
  read_count(grammar.steps, given ? std::optional(std::ceil(*given)) : given, kMostSteps, line, errors);
  if (given && *given > 0 && *given < kMostSteps) grammar.last_step = *given - (grammar.steps - 1);
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

Result<GrammarText> import_grammar(std::string_view file_name, std::string_view text,
                                   std::string_view system) {
  std::string plain = plain_text(text);
  GrammarKind kind = grammar_kind(file_name, plain);
  if (!system.empty() && kind != GrammarKind::fractint)
    return Error{"--system", "only files of Fractint hold several L-systems"};
  switch (kind) {
    case GrammarKind::lparser:
      return import_lparser(plain);
    case GrammarKind::fractint:
      return import_fractint(plain, system);
    case GrammarKind::skeleton:
      return import_skeleton(plain);
    case GrammarKind::cpfg:
    case GrammarKind::preset:
    case GrammarKind::houdini:
      break;
  }
  return import_houdini(plain);
}

}  // namespace frond
