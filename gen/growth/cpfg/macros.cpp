#include "cpfg/macros.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/plain_text.h"

namespace frond::cpfg {

namespace {

constexpr std::size_t kMostText = 8'000'000, kMostProduced = 50'000'000, kDeepest = 200;

/// The arguments in parentheses that the text begins with (after blanks), and how many bytes they take.
struct MacroArguments {
  std::vector<std::string> values;
  std::size_t length = 0;
};

std::optional<MacroArguments> arguments_of(std::string_view text) {
  std::size_t at = std::min(text.find_first_not_of(" \t\n"), text.size());
  if (at == text.size() || text[at] != '(') return std::nullopt;
  MacroArguments found{{""}, 0};
  int depth = 1;
  for (++at; at < text.size(); ++at) {
    if (std::size_t length = string_length(text.substr(at))) {
      found.values.back() += text.substr(at, length);
      at += length - 1;
      continue;
    }
    char c = text[at];
    depth += (c == '(') - (c == ')');
    if (depth == 0) {
      for (std::string& value : found.values) value = std::string(trim(value));
      found.length = at + 1;
      return found;
    }
    if (c == ',' && depth == 1)
      found.values.emplace_back();
    else
      found.values.back() += c == '\n' ? ' ' : c;
  }
  return std::nullopt;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

bool is_name_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || is_digit(c);
}

std::size_t name_length(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::find_if_not(text, is_name_letter) - text.begin());
}

std::size_t string_length(std::string_view text) {
  if (text.empty() || text[0] != '"') return 0;
  for (std::size_t i = 1; i < text.size() && text[i] != '\n'; ++i) {
    if (text[i] == '"') return i + 1;
    if (text[i] == '\\') ++i;
  }
  return 0;
}

void MacroTable::define(std::string_view text) {
  text = trim(text);
  std::size_t length = name_length(text);
  if (length == 0 || is_digit(text[0])) {
    error = fmt::format("`#define {}` has no name; expected `#define NAME text`", text);
    return;
  }
  std::string name(text.substr(0, length));
  text.remove_prefix(length);
  MacroText macro;
  if (text.starts_with('(')) {
    std::optional<MacroArguments> list = arguments_of(text);
    if (!list) {
      error = fmt::format("the parameters of the macro `{}` have no `)`", name);
      return;
    }
    macro.is_function = true;
    if (list->values.size() > 1 || !list->values[0].empty()) macro.parameters = list->values;
    text.remove_prefix(list->length);
  }
  macro.body = std::string(trim(text));
  macros[name] = std::move(macro);
}

std::string MacroTable::substitute(const std::string& name, const std::vector<std::string>& arguments,
                                   std::set<std::string, std::less<>>& within) {
  const MacroText& macro = macros.find(name)->second;
  std::size_t expected = macro.parameters.size();
  bool none = expected == 0 && arguments.size() == 1 && arguments[0].empty();
  if (!none && arguments.size() != expected) {
    error = fmt::format("the macro `{}` has {} arguments; expected {}", name, arguments.size(), expected);
    return {};
  }
  auto index_of = [&](std::string_view word) {
    return static_cast<std::size_t>(std::ranges::find(macro.parameters, word) - macro.parameters.begin());
  };
  std::string out;
  std::string_view body = macro.body;
  for (std::size_t at = 0; at < body.size() && out.size() < kMostText;) {
    if (std::size_t length = string_length(body.substr(at))) {
      out += body.substr(at, length);
      at += length;
    } else if (body.substr(at, 2) == "##") {  // joins its neighbours
      out.erase(out.find_last_not_of(" \t") + 1);
      at = std::min(body.find_first_not_of(" \t", at + 2), body.size());
    } else if (body[at] == '#' &&
               index_of(body.substr(at + 1, name_length(body.substr(at + 1)))) < expected) {
      std::size_t word = name_length(body.substr(at + 1));
      out += '"' + arguments[index_of(body.substr(at + 1, word))] + '"';
      at += 1 + word;
    } else if (std::size_t word = name_length(body.substr(at))) {
      std::size_t index = index_of(body.substr(at, word));
      std::size_t after = std::min(body.find_first_not_of(" \t", at + word), body.size());
      bool joined = body.substr(0, at).ends_with("##") || body.substr(after, 2) == "##";
      if (index == expected)
        out += body.substr(at, word);
      else
        out += joined ? arguments[index] : expand(arguments[index], within);
      at += word;
    } else {
      out += body[at++];
    }
  }
  return out;
}

std::string MacroTable::expand(std::string_view text, std::set<std::string, std::less<>>& within) {
  std::string out;
  if (++depth > kDeepest) error = "macros stand too deep in each other; expected at most 200 levels";
  for (std::size_t at = 0; at < text.size() && error.empty();) {
    std::size_t length = string_length(text.substr(at));
    if (length == 0) length = name_length(text.substr(at));
    std::string_view word = text.substr(at, std::max<std::size_t>(length, 1));
    at += word.size();
    auto macro = macros.find(word);
    std::optional<MacroArguments> arguments;
    if (macro != macros.end() && macro->second.is_function && !within.contains(word)) {
      arguments = arguments_of(text.substr(at));
      produced += arguments ? arguments->length : text.size() - at;
    }
    if (macro == macros.end() || within.contains(word) || (macro->second.is_function && !arguments)) {
      out += word;
      continue;
    }
    std::string name(word), body = macro->second.body;
    if (arguments) {
      body = substitute(name, arguments->values, within);
      at += arguments->length;
    }
    produced += body.size() + 1;
    if (produced > kMostProduced || out.size() + body.size() > kMostText)
      error = fmt::format(
          "the macro `{}` becomes too long a text; expected at most 8 MB, and 200 macros in each other",
          name);
    if (!error.empty()) break;
    within.insert(name);
    out += ' ' + expand(body, within) + ' ';
    within.erase(name);
  }
  --depth;
  return out;
}

std::string MacroTable::expanded(std::string_view text) {
  std::set<std::string, std::less<>> within;
  return expand(text, within);
}

bool MacroTable::is_open(std::string_view text) const {
  for (std::size_t at = 0; at < text.size();) {
    std::size_t length =
        std::max<std::size_t>({string_length(text.substr(at)), name_length(text.substr(at)), 1});
    auto macro = macros.find(text.substr(at, length));
    at += length;
    if (macro == macros.end() || !macro->second.is_function) continue;
    std::size_t open = text.find_first_not_of(" \t\n", at);
    if (open == text.npos || text[open] != '(') continue;
    std::optional<MacroArguments> arguments = arguments_of(text.substr(at));
    if (!arguments) return true;
    at += arguments->length;  // what it holds is closed, too
  }
  return false;
}

bool MacroTable::ends_in_call(std::string_view text) const {
  std::size_t end = text.find_last_not_of(" \t\n") + 1, from = end;
  while (from > 0 && is_name_letter(text[from - 1])) --from;
  auto macro = macros.find(text.substr(from, end - from));
  return macro != macros.end() && macro->second.is_function;
}

}  // namespace frond::cpfg
