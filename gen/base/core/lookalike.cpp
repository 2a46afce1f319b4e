#include "core/lookalike.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/utf8.h"

namespace frond {

namespace {

/// Characters that stand for one text.
struct Signs {
  std::u32string_view signs;
  std::string_view meant;
};

constexpr Signs kSigns[] = {
    {U"\u2010\u2011\u2012\u2013\u2014\u2015\u2212\u207b\ufe63\u2796", "-"},
    {U"\u207a\u2795\ufb29\ufe62", "+"},
    {U"\u00d7\u2217\u22c5\u00b7\u2219\u2715", "*"},
    {U"\u00f7\u2044\u2215\u29f8", "/"},
    {U"\u2216\u29f5\ufe68", "\\"},
    {U"\u2223\u2758\u2502\u01c0\u00a6", "|"},
    {U"\u02c6\u2038\u2303\u2227", "^"},
    {U"\u02dc\u223c\u301c\u2053", "~"},
    {U"\u201c\u201d\u201e\u2033\u02ba", "\""},
    {U"\u2018\u2019\u201a\u2032\u00b4\u02b9\u02bc", "'"},
    {U"\u2039\u27e8\u3008\u2329", "<"},
    {U"\u203a\u27e9\u3009\u232a", ">"},
    {U"\u3010\u3014\u27e6\u2045\u301a", "["},
    {U"\u3011\u3015\u27e7\u2046\u301b", "]"},
    {U"\u2768\u207d\ufe59", "("},
    {U"\u2769\u207e\ufe5a", ")"},
    {U"\u2774\ufe5b", "{"},
    {U"\u2775\ufe5c", "}"},
    {U"\u2236\ua789\u02d0\ufe55", ":"},
    {U"\u037e\ufe54", ";"},
    {U"\u3001\ufe50", ","},
    {U"\u3002\ufe52", "."},
    {U"\u2026", "..."},
    {U"\u01c3\ufe57", "!"},
    {U"\u2264\u2a7d", "<="},
    {U"\u2265\u2a7e", ">="},
    {U"\u2260", "!="},
    {U"\u00b2", "^2"},
    {U"\u00b3", "^3"},
    {U"\u27f6\u2794\u279d\u279e\u27a1\u21a6\u21d2\u27f9\u27fc\u21e8\uffeb", "->"},
};

/// Blanks that are none to the readers of rules, among them those without a width.
constexpr std::u32string_view kBlanks =
    U"\u00a0\u1680\u2000\u2001\u2002\u2003\u2004\u2005\u2006\u2007\u2008\u2009\u200a\u202f\u205f\u3000"
    U"\u00ad\u200b\u200c\u200d\u2060\ufeff";

/// Letters of Greek and Cyrillic with the shape of a Latin one, in pairs.
struct Twin {
  char32_t other;
  char latin;
};
constexpr Twin kTwins[] = {
    {U'\u0391', 'A'}, {U'\u0392', 'B'}, {U'\u0395', 'E'}, {U'\u0396', 'Z'}, {U'\u0397', 'H'},
    {U'\u0399', 'I'}, {U'\u039a', 'K'}, {U'\u039c', 'M'}, {U'\u039d', 'N'}, {U'\u039f', 'O'},
    {U'\u03a1', 'P'}, {U'\u03a4', 'T'}, {U'\u03a5', 'Y'}, {U'\u03a7', 'X'}, {U'\u03bf', 'o'},
    {U'\u03dc', 'F'}, {U'\u0410', 'A'}, {U'\u0412', 'B'}, {U'\u0415', 'E'}, {U'\u0405', 'S'},
    {U'\u0406', 'I'}, {U'\u0408', 'J'}, {U'\u041a', 'K'}, {U'\u041c', 'M'}, {U'\u041d', 'H'},
    {U'\u041e', 'O'}, {U'\u0420', 'P'}, {U'\u0421', 'C'}, {U'\u0422', 'T'}, {U'\u0425', 'X'},
    {U'\u0430', 'a'}, {U'\u0435', 'e'}, {U'\u043e', 'o'}, {U'\u0440', 'p'}, {U'\u0441', 'c'},
    {U'\u0443', 'y'}, {U'\u0445', 'x'}, {U'\u0455', 's'}, {U'\u0456', 'i'}, {U'\u0458', 'j'}};

/// What a character stands for; nothing where it is no lookalike.
std::string meaning_of(char32_t code) {
  if (code >= 0xff01 && code <= 0xff5e) return std::string(1, static_cast<char>(code - 0xfee0));
  for (const Signs& row : kSigns)
    if (row.signs.find(code) != row.signs.npos) return std::string(row.meant);
  return kBlanks.find(code) != kBlanks.npos ? " " : "";
}

}  // namespace

std::optional<Lookalike> find_lookalike(std::string_view text, std::size_t from) {
  for (std::size_t at = from; at < text.size();) {
    std::size_t size = std::max<std::size_t>(character_size(text.substr(at, 4)), 1);
    std::string_view character = text.substr(at, size);
    if (size > 1) {
      char32_t code = code_of(character);
      if (std::string meant = meaning_of(code); meant == " ")
        return Lookalike{at, size, fmt::format("U+{:04X}", static_cast<unsigned>(code)), "a blank"};
      else if (!meant.empty())
        return Lookalike{at, size, fmt::format("`{}` (U+{:04X})", character, static_cast<unsigned>(code)),
                         fmt::format("`{}`", meant)};
    }
    at += size;
  }
  return std::nullopt;
}

char latin_lookalike(std::string_view character) {
  if (character.size() < 2 || character_size(character) != character.size()) return '\0';
  const Twin* twin = std::ranges::find(kTwins, code_of(character), &Twin::other);
  return twin == std::end(kTwins) ? '\0' : twin->latin;
}

std::size_t column_of(std::string_view text, std::size_t at) {
  text = text.substr(0, at);
  return 1 + static_cast<std::size_t>(std::ranges::count_if(
                 text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

}  // namespace frond
