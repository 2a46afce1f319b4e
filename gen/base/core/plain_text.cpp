#include "core/plain_text.h"

#include "core/text.h"
#include "core/utf8.h"

namespace frond {

namespace {

/// Pairs of bytes behind their mark. Halves of pairs that stand alone become U+FFFD.
std::string from_utf16(std::string_view bytes, bool big) {
  std::string text;
  auto unit = [&](std::size_t at) {
    auto byte = [&](std::size_t i) { return char32_t{static_cast<unsigned char>(bytes[i])}; };
    return big ? byte(at) << 8 | byte(at + 1) : byte(at + 1) << 8 | byte(at);
  };
  for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
    char32_t code = unit(at);
    bool half = code >= 0xd800 && code < 0xe000, first = half && code < 0xdc00 && at + 3 < bytes.size();
    char32_t second = first ? unit(at + 2) : 0;
    if (first && second >= 0xdc00 && second < 0xe000)
      code = 0x10000 + ((code - 0xd800) << 10) + (second - 0xdc00), at += 2;
    else if (half)
      code = 0xfffd;
    append_utf8(text, code);
  }
  return text;
}

}  // namespace

std::string plain_text(std::string_view bytes) {
  std::string decoded;
  bool big = bytes.starts_with("\xfe\xff");
  if (big || bytes.starts_with("\xff\xfe")) bytes = decoded = from_utf16(bytes.substr(2), big);
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  bytes = bytes.substr(0, bytes.find('\x1a'));
  std::string text;
  text.reserve(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (bytes[i] != '\r')
      text += bytes[i];
    else if (i + 1 == bytes.size() || bytes[i + 1] != '\n')
      text += '\n';
  }
  return text;
}

std::string_view trim(std::string_view text) {
  std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

bool has_ending(std::string_view name, std::string_view ending) { return lower_case(name).ends_with(ending); }

}  // namespace frond
