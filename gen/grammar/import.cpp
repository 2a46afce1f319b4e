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

void take_steps(GrammarText& grammar, std::optional<double> given, const Line& line, Errors& errors) {
  take_count(grammar.steps, given ? std::optional(std::ceil(*given)) : given, kMostSteps, line, errors);
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

Result<GrammarText> import_grammar(std::string_view file_name, std::string_view text) {
  if (file_name.ends_with(".ls")) return import_lparser(text);
  return import_houdini(text);
}

}  // namespace frond
