#include "jobs/escape.h"

#include <algorithm>

#include "core/utf8.h"

namespace frond {

std::string shell_quoted(std::string_view text) {
  std::string quoted = "'";
  for (char c : text) {
    if (c == '\'')
      quoted += "'\\''";
    else
      quoted += c;
  }
  return quoted += '\'';
}

std::string ninja_path(std::string_view text) {
  std::string escaped;
  for (char c : text) {
    if (c == '\n' || c == '\r' || c == '\0') c = ' ';
    if (c == '$' || c == ' ' || c == ':') escaped += '$';
    escaped += c;
  }
  return escaped;
}

std::string ninja_value(std::string_view text) {
  std::string escaped;
  for (char c : text) {
    if (c == '\n' || c == '\r' || c == '\0') c = ' ';
    if (c == '$' || (c == ' ' && escaped.empty())) escaped += '$';  // blanks in front are skipped
    escaped += c;
  }
  return escaped;
}

std::string json_quoted(std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string quoted = "\"";
  for (std::size_t size = 0; !text.empty(); text.remove_prefix(size)) {
    std::string_view character = text.substr(0, character_size(text.substr(0, 4)));
    size = std::max<std::size_t>(character.size(), 1);
    char c = text[0];
    unsigned char byte = static_cast<unsigned char>(c);
    if (character.empty()) {
      quoted += "\\ufffd";
    } else if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (c == '\n') {
      quoted += "\\n";
    } else if (byte < 0x20) {
      quoted += "\\u00";
      quoted += kHex[byte >> 4];
      quoted += kHex[byte & 15];
    } else {
      quoted += character;
    }
  }
  return quoted += '"';
}

}  // namespace frond
