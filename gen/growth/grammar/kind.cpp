#include "grammar/kind.h"

#include <algorithm>
#include <string>
#include <vector>

#include "core/plain_text.h"
#include "grammar/import_text.h"

namespace frond {

namespace {

using namespace import_text;

/// The first lines of a text without comments, in lower case.
struct Lines {
  std::vector<std::string> all;   ///< as they are
  std::vector<std::string> data;  ///< up to `#` or `;`

  explicit Lines(std::string_view text) {
    constexpr std::size_t kMost = 4000;
    std::string plain = plain_text(text.substr(0, 1'000'000));
    for (const Line& line : lines_of(plain)) {
      if (all.size() == kMost) break;
      std::string lower(line.text);
      for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
      std::string_view kept = trim(std::string_view(lower).substr(0, lower.find_first_of("#;")));
      if (!kept.empty()) data.emplace_back(kept);
      all.push_back(std::move(lower));
    }
  }

  /// Whether a line begins with a word and one of the signs.
  bool begins(std::string_view word, std::string_view signs) const {
    return std::ranges::any_of(all, [&](std::string_view line) {
      return line.starts_with(word) && line.size() > word.size() &&
             signs.find(line[word.size()]) != signs.npos;
    });
  }
};

bool is_cpfg(const Lines& lines) {
  for (std::string_view word :
       {"lsystem", "derivation length", "production", "interpretation", "homomorphism"})
    if (lines.begins(word, ": ") && std::ranges::any_of(lines.all, [&](std::string_view line) {
          return line.starts_with(word) && trim(line.substr(word.size())).starts_with(':');
        }))
      return true;
  return std::ranges::any_of(lines.all, [](std::string_view line) {
    return line.starts_with("#include") || line.starts_with("#define ") || line.starts_with("import ") ||
           (line.starts_with("from ") && line.find(" import ") != line.npos) || line == "endlsystem";
  });
}

/// Whether every line has seven numbers, of which the last names a line before or none.
bool is_skeleton(const Lines& lines) {
  std::size_t seen = 0;
  for (const std::string& line : lines.data) {
    std::size_t numbers = 0;
    for (std::string_view rest = line; !rest.empty() && numbers < 7; ++numbers) {
      std::size_t end = std::min(rest.find_first_of(" \t,"), rest.size());
      if (!number(rest.substr(0, end))) return false;
      rest = trim(rest.substr(end + (end < rest.size() && rest[end] == ',' ? 1 : 0)));
    }
    if (numbers < 7) return false;
    ++seen;
  }
  return seen > 0;
}

bool is_fractint(const Lines& lines) {
  bool opened = std::ranges::any_of(lines.data, [](std::string_view line) {
    std::size_t brace = line.find('{');
    return brace != line.npos && line.substr(0, brace).find_first_of("=:([") == line.npos;
  });
  bool axiom = std::ranges::any_of(lines.data, [](std::string_view line) {
    std::size_t at = line.find("axiom");
    return at != line.npos && (at == 0 || line[at - 1] == ' ' || line[at - 1] == '{' || line[at - 1] == '\t');
  });
  return opened && axiom && !lines.begins("rule", " \t");
}

}  // namespace

GrammarKind grammar_kind(std::string_view file_name, std::string_view text) {
  Lines lines(text);
  bool comment = !lines.all.empty() && (lines.all[0].starts_with("//") || lines.all[0].starts_with("/*"));
  if (has_ending(file_name, ".json") || (!lines.all.empty() && lines.all[0].starts_with('{') && !comment))
    return GrammarKind::preset;
  if (has_ending(file_name, ".lpy")) return GrammarKind::cpfg;
  if (is_skeleton(lines)) return GrammarKind::skeleton;
  bool numbers = lines.data.size() > 2 && number(lines.data[0]) && number(lines.data[1]);
  if (numbers || lines.begins("rule", " \t") || lines.begins("recursion", " \t")) return GrammarKind::lparser;
  if (is_cpfg(lines)) return GrammarKind::cpfg;
  if (is_fractint(lines)) return GrammarKind::fractint;
  if (lines.begins("premise", ": ")) return GrammarKind::houdini;
  return has_ending(file_name, ".ls")    ? GrammarKind::lparser
         : has_ending(file_name, ".l")   ? GrammarKind::cpfg
         : has_ending(file_name, ".swc") ? GrammarKind::skeleton
                                         : GrammarKind::houdini;
}

}  // namespace frond
