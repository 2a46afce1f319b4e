#include "grammar/houdini_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "grammar/expression.h"
#include "grammar/import_text.h"

namespace frond {

namespace {

constexpr std::string_view kLeaves = "JKM", kColorSigns = "'#";

struct Missing {
  std::string_view name, what;
};
constexpr Missing kMissing[] = {
    {"pic", "reads a picture of its node; take it out, or give the node's value in its place"},
    {"in",
     "asks whether a place lies within the shape at the node's second input; ways round: give the shape as a "
     "formula of x, y and z, as `x*x+(y-1)*(y-1)+z*z<1`; let the kind `colonized` fill it; or ask ?E in a "
     "grammar of Frond how far the bodies of a scene are"},
    {"chan", "reads a channel of its node; give the node's value in its place"}};

/// Symbols that the turtle knows; all other letters only have rules.
constexpr std::string_view kTurtleLetters = "FGHJKMTfgh";

bool in(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

void add(std::string& set, char c) {
  if (set.find(c) == set.npos) set += c;
}

}  // namespace

bool draws_nothing(char symbol) {
  bool letter = (symbol >= 'A' && symbol <= 'Z') || (symbol >= 'a' && symbol <= 'z');
  return letter && kTurtleLetters.find(symbol) == kTurtleLetters.npos;
}

std::size_t closing(std::string_view text, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    if (text[i] == '(') ++depth;
    if (text[i] == ')' && --depth == 0) return i;
  }
  return text.size();
}

std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> parts;
  int depth = 0;
  std::size_t from = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') ++depth;
    if (text[i] == ')') --depth;
    if (text[i] != ',' || depth != 0) continue;
    parts.push_back(trim(text.substr(from, i - from)));
    from = i + 1;
  }
  parts.push_back(trim(text.substr(from)));
  return parts;
}

std::vector<std::string> parameters_in(std::string_view head) {
  std::vector<std::string> names;
  for (std::size_t open = head.find('('); open != head.npos; open = head.find('(', open + 1)) {
    std::size_t close = closing(head, open);
    for (std::string_view part : parts_of(head.substr(open + 1, close - open - 1))) names.emplace_back(part);
  }
  return names;
}

std::string each_module(std::string_view word,
                        const std::function<std::string(char symbol, std::string_view inside)>& change) {
  std::string out;
  for (std::size_t i = 0; i < word.size(); ++i) {
    char symbol = word[i];
    std::string_view inside;
    if (i + 1 < word.size() && word[i + 1] == '(') {
      std::size_t open = i + 1;
      i = closing(word, open);
      inside = word.substr(open + 1, i - open - 1);
    }
    out += change(symbol, inside);
  }
  return out;
}

std::string HoudiniWords::name(std::string_view found, const std::vector<std::string>& parameters,
                               bool call) {
  for (const Missing& missing : kMissing)
    if (call && missing.name == found)
      return refuse(fmt::format("`{}` {}", found, missing.what), found), std::string(found);
  if (call || in(parameters, found) || found.size() != 1) return std::string(found);
  switch (found[0]) {
    case 't':
      return "step";
    case 'g':
      takes_age = true;
      return "g_";
    case 'x':
    case 'y':
    case 'z':
      takes_position = true;
      return fmt::format("{}_", found);
    default:
      add(names, found[0]);
  }
  return std::string(found);
}

std::string HoudiniWords::formula(std::string_view text, const std::vector<std::string>& parameters) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    Cursor reader{text, i};
    std::string_view found = consume_identifier(reader);
    bool letter = !found.empty() && found.data() == text.data() + i;
    if (letter) {
      i += found.size();
      bool call = i < text.size() && text[i] == '(';
      out += name(found, parameters, call);
      bool single =
          call && found == "rand" && parts_of(text.substr(i + 1, closing(text, i) - i - 1)).size() == 1;
      if (single) out += "(0,", ++i;
      continue;
    }
    char c = text[i++];
    out += c;
    if (c != '&' && c != '|') continue;
    out += c;
    if (i < text.size() && text[i] == c) ++i;
  }
  return out;
}

std::string HoudiniWords::parameters_of(char symbol, std::string_view inside,
                                        const std::vector<std::string>& parameters) {
  std::vector<std::string_view> parts = parts_of(inside);
  if (kColorSigns.find(symbol) != kColorSigns.npos) return colors = true, "";
  if (kLeaves.find(symbol) != kLeaves.npos) {
    stamps |= parts.size() > 1;
    return parts[0].empty() ? "" : fmt::format("({})", formula(parts[0], parameters));
  }
  std::string out;
  for (std::string_view part : parts) {
    bool drawn = !draws_nothing(symbol);
    if (part.empty() && drawn)
      refuse(fmt::format("`{}({})` leaves out a parameter; give its value", symbol, inside), inside);
    out += (out.empty() ? "(" : ",") + (part.empty() ? "0" : formula(part, parameters));
  }
  return out + ")";
}

std::string HoudiniWords::word(std::string_view text, const std::vector<std::string>& parameters) {
  std::string out;
  if (text.find('`') != text.npos)
    return refuse("what stands in backquotes is worked out by Houdini itself; give its value",
                  text.substr(text.find('`'))),
           "";
  if (text.find("a(\"") != text.npos)
    return refuse("`a(\"…\")` names an attribute of points; take it out", text.substr(text.find("a(\""))), "";
  for (std::size_t i = 0; i < text.size(); ++i) {
    char c = text[i];
    out += c;
    std::size_t open = i + 1;
    while (open < text.size() && text[open] == ' ') ++open;
    if (c == ' ' || open >= text.size() || text[open] != '(') {
      if (c != ' ') add(used, c), add(bare, c);
      continue;
    }
    add(used, c);
    std::size_t close = closing(text, open);
    if (close == text.size())
      return refuse(fmt::format("a `)` is missing in `{}`", text), text.substr(open)), "";
    out += parameters_of(c, text.substr(open + 1, close - open - 1), parameters);
    i = close;
  }
  return out;
}

}  // namespace frond
