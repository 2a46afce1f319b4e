#include "core/printable.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/content.h"
#include "core/utf8.h"

namespace frond {

namespace {

constexpr std::size_t kMostPlace = 400, kMostPointer = 400;
constexpr std::string_view kGap = "[...]";

/// Whether a terminal does something else with it than to show it.
bool steers(char32_t code) {
  bool control = code < 0x20 || (code >= 0x7f && code < 0xa0);
  bool direction = code == 0x061c || code == 0x200e || code == 0x200f || (code >= 0x202a && code <= 0x202e) ||
                   (code >= 0x2066 && code <= 0x2069);
  return control || direction || code == 0x2028 || code == 0x2029;
}

/// Whether a character goes on at that byte.
bool continues(std::string_view text, std::size_t at) {
  return at < text.size() && (text[at] & 0xc0) == 0x80;
}

/// The text without its middle, where it is longer than that. No character is cut in two.
std::string cut(std::string_view text, std::size_t most) {
  most = std::max<std::size_t>(most, 16);
  if (text.size() <= most) return std::string(text);
  std::size_t front = (most - kGap.size()) * 2 / 3, back = text.size() - (most - kGap.size() - front);
  for (int i = 0; i < 3 && continues(text, front); ++i) --front;
  for (int i = 0; i < 3 && continues(text, back); ++i) ++back;
  return fmt::format("{}{}{}", text.substr(0, front), kGap, text.substr(back));
}

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
  // What is cut away need not be escaped first.
  std::string near = cut(text, most), shown;
  for (std::size_t i = 0; i < near.size();) {
    std::string_view rest = std::string_view(near).substr(i);
    std::size_t size = character_size(rest.substr(0, 4));
    std::string_view character = rest.substr(0, std::max<std::size_t>(size, 1));
    char32_t code = size > 0 ? code_of(character) : static_cast<unsigned char>(character[0]);
    if (size > 0 && !steers(code)) {
      shown += character;
    } else {
      shown += size > 1 ? fmt::format("\\u{:04x}", static_cast<unsigned>(code))
                        : fmt::format("\\x{:02x}", static_cast<unsigned>(code));
    }
    i += character.size();
  }
  return cut(shown, most);
}

std::string printable(const Error& error) {
  std::size_t pointer = std::min(error.where.find(": /"), error.where.size());
  std::string text = printable(std::string_view(error.where).substr(0, pointer), kMostPlace);
  if (pointer < error.where.size())
    text += ": " + printable(std::string_view(error.where).substr(pointer + 2), kMostPointer);
  return (text.empty() ? text : text + ": ") + printable(error.what);
}

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
         c == '-';
}

std::string plain_name(const std::string& name, std::string_view otherwise) {
  std::string text = name;
  std::ranges::replace_if(
      text, [](char c) { return !is_plain(c) || c == '.'; }, '_');
  if (text.size() > kLongestName) text = text.substr(0, kLongestName - 17) + '_' + content_id(name);
  return text.empty() ? std::string(otherwise) : text;
}

std::string xml_quoted(std::string_view text) {
  std::string quoted;
  for (char c : text) {
    if (c == '&')
      quoted += "&amp;";
    else if (c == '<')
      quoted += "&lt;";
    else if (c == '>')
      quoted += "&gt;";
    else if (c == '"')
      quoted += "&quot;";
    else
      quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return quoted;
}

}  // namespace frond
