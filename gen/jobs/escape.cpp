#include "jobs/escape.h"

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
  for (char c : text) {
    unsigned char byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (c == '\n') {
      quoted += "\\n";
    } else if (byte < 0x20) {
      quoted += "\\u00";
      quoted += kHex[byte >> 4];
      quoted += kHex[byte & 15];
    } else {
      quoted += c;
    }
  }
  return quoted += '"';
}

}  // namespace frond
