#include "grammar/read.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/lookalike.h"
#include "grammar/rewrite.h"

namespace frond {

namespace {

/// Bytes of the UTF-8 letter that starts with `first`.
std::size_t letter_size(char first) {
  auto byte = static_cast<unsigned char>(first);
  return byte < 0xC0 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
}

/// Where `word` stands outside parentheses, from `begin` to before `end`; npos where it does not.
std::size_t find_outside(std::string_view text, std::string_view word, std::size_t begin, std::size_t end) {
  int depth = 0;
  for (std::size_t i = begin; i + word.size() <= end; ++i) {
    if (text[i] == '(') ++depth;
    if (text[i] == ')') --depth;
    if (depth == 0 && text.substr(i, word.size()) == word) return i;
  }
  return std::string_view::npos;
}

bool blank(std::string_view text, std::size_t begin, std::size_t end) {
  return text.substr(begin, end - begin).find_first_not_of(" \t\r\n") == std::string_view::npos;
}

/// The arrow of a rule: `->`, `-->` or the arrow letter. A `-` before `->` belongs to the arrow unless it is
/// all that could be the predecessor.
std::optional<RuleParts::Part> find_arrow(std::string_view text) {
  constexpr std::string_view kLetter = "\u2192";
  std::size_t letter = find_outside(text, kLetter, 0, text.size());
  std::size_t plain = find_outside(text, "->", 0, text.size());
  if (letter < plain) return RuleParts::Part{letter, letter + kLetter.size()};
  if (plain == text.npos) return std::nullopt;
  bool longer = plain > 0 && text[plain - 1] == '-' && !blank(text, 0, plain - 1);
  std::string_view before = text.substr(0, longer ? plain - 1 : plain);
  std::size_t last = before.find_last_not_of(" \t");
  if (longer && last != before.npos && before[last] == '<') longer = false;
  return RuleParts::Part{longer ? plain - 1 : plain, plain + 2};
}

}  // namespace

SymbolId ModuleReader::id(std::string_view name, int arity, Cursor& reader) {
  std::vector<Symbol>& symbols = grammar_.symbols;
  if (arity > kMostParameters)
    reader.fail(fmt::format("`{}` has {} parameters; {} are the most", name, arity, kMostParameters),
                reader.at);
  for (std::size_t i = 0; i < symbols.size(); ++i)
    if (symbols[i].name == name && symbols[i].arity == arity) return static_cast<SymbolId>(i);
  if (symbols.size() == 256) {
    reader.fail(
        "more than 256 different symbols (a name with another number of parameters counts as another); use "
        "fewer",
        reader.at);
    return 0;
  }
  symbols.push_back({std::string(name), arity, act_of(name, grammar_.text.dialect), true});
  return static_cast<SymbolId>(symbols.size() - 1);
}

std::string_view ModuleReader::consume_name(Cursor& reader) const {
  if (reader.at_end()) return {};
  std::string_view rest = reader.text.substr(reader.at), name;
  for (const std::string& symbol : grammar_.text.symbols)
    if (symbol.size() > name.size() && rest.starts_with(symbol)) name = rest.substr(0, symbol.size());
  if (name.empty()) name = long_symbol_at(rest, grammar_.text.dialect);
  if (name.empty()) name = rest.substr(0, letter_size(rest[0]));
  if (name == "(" || name == ")") {
    reader.fail(name == "(" ? "a `(` without a symbol before it" : "a `)` without its `(`", reader.at);
    return {};
  }
  reader.at += name.size();
  return name;
}

void ModuleReader::read_modules(Cursor& reader, std::span<const std::string> variables,
                                std::vector<SymbolId>& modules, std::vector<Expression>& arguments,
                                std::string_view bracket) {
  std::vector<std::size_t> open;
  if (bracket == "]") open.push_back(reader.text.npos);  // the branch that it ends
  places.clear();
  while (!reader.at_end() && !reader.failed()) {
    std::size_t start = reader.at;
    std::string_view name = consume_name(reader);
    if (name == "[") open.push_back(start);
    if (name == "]") {
      if (open.empty()) return reader.fail("this `]` closes no `[`; remove it or open the branch", start);
      open.pop_back();
    }
    int arity = 0;
    if (!reader.failed() && reader.consume("(")) {
      do {
        arguments.push_back(read_expression(reader, {variables, constants}));
        ++arity;
      } while (!reader.failed() && reader.consume(","));
      if (!reader.failed() && !reader.consume(")"))
        reader.fail(fmt::format("the parameters of `{}` are not closed; a `,` or `)` is expected", name),
                    reader.at);
    }
    if (!reader.failed()) modules.push_back(id(name, arity, reader)), places.push_back(start);
  }
  bool starts = bracket == "[";
  if (starts ? open.empty() : !open.empty() && open[0] == reader.text.npos)
    return reader.fail(fmt::format("what is drawn for `{0}` holds a `{0}` of its own; add it", bracket), 0);
  if (starts) open.pop_back();
  if (!open.empty()) reader.fail("this `[` is not closed; add a `]`", open.back());
}

void ModuleReader::read_pattern(Cursor& reader, std::vector<std::string>& variables,
                                std::vector<SymbolId>& modules) {
  places.clear();
  while (!reader.at_end() && !reader.failed()) {
    std::size_t begin = reader.at;
    std::string_view name = consume_name(reader);
    int arity = 0;
    if (!reader.failed() && reader.consume("(")) {
      do {
        std::size_t start = (reader.skip_blanks(), reader.at);
        std::string_view variable = consume_identifier(reader);
        if (variable.empty())
          return reader.fail("a parameter of the left side is a name; put numbers into the condition", start);
        if (std::find(variables.begin(), variables.end(), variable) != variables.end())
          return reader.fail(fmt::format("the parameter `{}` is named twice; rename one", variable), start);
        variables.emplace_back(variable);
        ++arity;
      } while (reader.consume(","));
      if (!reader.consume(")")) reader.fail("a `)` is missing", reader.at);
    }
    if (!reader.failed()) modules.push_back(id(name, arity, reader)), places.push_back(begin);
  }
}

std::optional<RuleParts> split_rule(Cursor& reader) {
  std::string_view text = reader.text;
  std::optional<RuleParts::Part> arrow = find_arrow(text);
  if (!arrow) return reader.fail("no arrow; a rule is `predecessor -> successor`", text.size()), std::nullopt;
  RuleParts parts;
  std::size_t colon = std::min(find_outside(text, ":", 0, arrow->begin), arrow->begin);
  if (colon < arrow->begin) parts.condition = {colon + 1, arrow->begin};
  std::size_t less = find_outside(text, "<", 0, colon);
  if (less != text.npos) parts.left = {0, less};
  std::size_t start = less == text.npos ? 0 : less + 1;
  std::size_t greater = std::min(find_outside(text, ">", start, colon), colon);
  if (greater < colon) parts.right = {greater + 1, colon};
  parts.predecessor = {start, greater};
  if (blank(text, start, greater))
    return reader.fail("there is no predecessor; a rule is `predecessor -> successor`", start), std::nullopt;

  std::size_t after = arrow->end;
  while (after < text.size() && (text[after] == ' ' || text[after] == '\t')) ++after;
  parts.successor = {after, text.size()};
  if (after < text.size() && text[after] == '(') {
    std::size_t close = find_outside(text, ")", after, text.size());
    if (close == text.npos)
      return reader.fail("the weight is not closed; a `)` is missing", after), std::nullopt;
    parts.weight = {after + 1, close};
    parts.successor.begin = close + 1;
  }
  return parts;
}

Error complaint(const Cursor& reader, std::string_view where) {
  return error_at(std::string(where), "column {}: {}; in `{}`", column_of(reader.text, reader.mistake_at),
                  reader.mistake, reader.text);
}

}  // namespace frond
