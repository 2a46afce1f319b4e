#include "preset/scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace frond {
namespace {

bool digit(char c) { return c >= '0' && c <= '9'; }
bool continuation(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

/// Length of the UTF-8 sequence that begins the text, 0 where it is none (table 3-7 of the Unicode standard).
std::size_t sequence_length(std::string_view text) {
  auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  auto between = [&](std::size_t i, unsigned low, unsigned high) {
    return byte(i) >= low && byte(i) <= high;
  };
  auto tail = [&](std::size_t i) { return between(i, 0x80, 0xbf); };
  unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first <= 0xdf) return tail(1) ? 2 : 0;
  if (first >= 0xe0 && first <= 0xef) {
    bool second = between(1, first == 0xe0 ? 0xa0 : 0x80, first == 0xed ? 0x9f : 0xbf);
    return second && tail(2) ? 3 : 0;
  }
  if (first >= 0xf0 && first <= 0xf4) {
    bool second = between(1, first == 0xf0 ? 0x90 : 0x80, first == 0xf4 ? 0x8f : 0xbf);
    return second && tail(2) && tail(3) ? 4 : 0;
  }
  return 0;
}

void append_utf8(std::string& text, unsigned code) {
  auto put = [&](unsigned byte) { text += static_cast<char>(byte); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xc0 | code >> 6), put(0x80 | (code & 0x3f));
  } else if (code < 0x10000) {
    put(0xe0 | code >> 12), put(0x80 | (code >> 6 & 0x3f)), put(0x80 | (code & 0x3f));
  } else {
    put(0xf0 | code >> 18), put(0x80 | (code >> 12 & 0x3f)), put(0x80 | (code >> 6 & 0x3f)),
        put(0x80 | (code & 0x3f));
  }
}

/// Whether the number is below 1: its first digit that counts stands behind the point.
bool below_one(std::string_view number) {
  std::size_t exponent_at = number.find_first_of("eE");
  std::string_view digits = number.substr(0, exponent_at);
  std::size_t first = digits.find_first_of("123456789");
  if (first == digits.npos) return true;
  long long point = static_cast<long long>(std::min(digits.find('.'), digits.size()));
  long long magnitude = point - static_cast<long long>(first);
  if (exponent_at == number.npos) return magnitude <= 0;
  std::string_view exponent = number.substr(exponent_at + 1);
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  long long power = 0;
  auto [end, fault] = std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
  if (fault != std::errc()) return exponent.starts_with('-');
  return power <= -magnitude;
}

}  // namespace

std::optional<std::size_t> invalid_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    std::size_t length = sequence_length(text.substr(i, 4));
    if (length == 0) return i;
    i += length;
  }
  return std::nullopt;
}

Scanner::Scanner(std::string_view text) : text_(text) {
  if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
}

Scanner::Place Scanner::place(std::size_t offset) {
  if (offset < placed_offset_) placed_offset_ = 0, placed_ = Place{};
  for (; placed_offset_ < offset; ++placed_offset_) {
    if (text_[placed_offset_] == '\n') {
      ++placed_.line;
      placed_.column = 1;
    } else if (!continuation(text_[placed_offset_])) {
      ++placed_.column;
    }
  }
  return placed_;
}

std::size_t Scanner::skip_blanks() {
  for (;;) {
    while (!at_end() && std::string_view(" \t\r\n").find(peek()) != std::string_view::npos) ++offset_;
    std::string_view rest = text_.substr(offset_);
    if (rest.starts_with("//")) {
      offset_ = std::min(text_.find('\n', offset_), text_.size());
    } else if (rest.starts_with("/*")) {
      std::size_t end = rest.find("*/", 2);
      if (end == rest.npos) return offset_;
      offset_ += end + 2;
    } else {
      return kNone;
    }
  }
}

std::string_view Scanner::word() const {
  std::size_t end = offset_;
  while (end < text_.size() && text_[end] >= 'a' && text_[end] <= 'z') ++end;
  return text_.substr(offset_, end - offset_);
}

Scanner::Number Scanner::number() const {
  std::size_t at = offset_;
  auto here = [&] { return at < text_.size() ? text_[at] : '\0'; };
  auto digits = [&] {
    std::size_t first = at;
    while (digit(here())) ++at;
    return at > first;
  };

  Number number;
  if (here() == '-') ++at;
  if (here() == '0') {
    ++at;
  } else if (!digits()) {
    return number;
  }
  if (here() == '.') {
    ++at;
    number.integer = false;
    if (!digits()) return Number{};
  }
  if (here() == 'e' || here() == 'E') {
    ++at;
    number.integer = false;
    if (here() == '+' || here() == '-') ++at;
    if (!digits()) return Number{};
  }
  number.text = text_.substr(offset_, at - offset_);
  number.tiny = below_one(number.text);
  return number;
}

Scanner::TextFault Scanner::read_text(std::string& text) {
  std::size_t start = offset_++;
  while (!at_end()) {
    char c = peek();
    if (c == '"') {
      ++offset_;
      return {};
    }
    if (static_cast<unsigned char>(c) < 0x20) {
      return {offset_, "a line break or control character inside a text; expected an escape such as \\n"};
    }
    if (c == '\\') {
      TextFault fault = read_escape(text);
      if (!fault.what.empty()) return fault;
    } else {
      text += c;
      ++offset_;
    }
  }
  return {start, "a text without end; expected a closing '\"'"};
}

Scanner::TextFault Scanner::read_escape(std::string& text) {
  constexpr std::string_view kLetters = "\"\\/bfnrt";
  constexpr std::string_view kMeanings = "\"\\/\b\f\n\r\t";
  std::size_t start = offset_;
  char letter = start + 1 < text_.size() ? text_[start + 1] : '\0';
  if (std::size_t which = kLetters.find(letter); letter != '\0' && which != kLetters.npos) {
    text += kMeanings[which];
    offset_ += 2;
    return {};
  }
  std::optional<unsigned> code = letter == 'u' ? hex4(start + 2) : std::nullopt;
  if (!code) return {start, "an unknown escape; expected one of \\\" \\\\ \\/ \\b \\f \\n \\r \\t \\uXXXX"};
  offset_ += 6;

  // Characters beyond U+FFFF are written as two halves.
  if (*code >= 0xd800 && *code <= 0xdfff) {
    std::optional<unsigned> low = text_.substr(offset_).starts_with("\\u") ? hex4(offset_ + 2) : std::nullopt;
    if (*code >= 0xdc00 || !low || *low < 0xdc00 || *low > 0xdfff) {
      return {start, "half a surrogate pair; expected \\uD800 to \\uDBFF and then \\uDC00 to \\uDFFF"};
    }
    code = 0x10000 + ((*code & 0x3ff) << 10) + (*low & 0x3ff);
    offset_ += 6;
  }
  append_utf8(text, *code);
  return {};
}

std::optional<unsigned> Scanner::hex4(std::size_t at) const {
  std::string_view digits = text_.substr(std::min(at, text_.size()), 4);
  unsigned code = 0;
  auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
  bool whole = digits.size() == 4 && fault == std::errc() && end == digits.data() + digits.size();
  return whole ? std::optional(code) : std::nullopt;
}

std::string Scanner::next_text() const {
  if (at_end()) return "the end of the text";
  std::string_view rest = text_.substr(offset_);
  if (static_cast<unsigned char>(rest[0]) < 0x20) return "a control character";
  return fmt::format("'{}'", rest.substr(0, sequence_length(rest)));
}

}  // namespace frond
