#include "preset/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "core/utf8.h"

namespace frond {
namespace {

char byte_at(std::string_view text, std::size_t offset) { return offset < text.size() ? text[offset] : '\0'; }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

TokenFault unknown_escape(std::size_t offset) {
  return {offset, R"(an unknown escape; expected one of \" \\ \/ \b \f \n \r \t \uXXXX)"};
}

/// The code of `\uXXXX` at `offset`, where that is what stands there.
std::optional<std::uint32_t> code_at(std::string_view text, std::size_t offset) {
  std::string_view escape = text.substr(std::min(offset, text.size()), 6);
  if (escape.size() < 6 || !escape.starts_with("\\u")) return std::nullopt;
  std::uint32_t code = 0;
  auto [end, fault] = std::from_chars(escape.data() + 2, escape.data() + 6, code, 16);
  return fault == std::errc() && end == escape.data() + 6 ? std::optional(code) : std::nullopt;
}

/// Reads `\uXXXX`, or two of them that are one character.
std::optional<TokenFault> read_code(std::string_view text, std::size_t& offset, std::string& into) {
  const std::size_t start = offset;
  std::optional<std::uint32_t> code = code_at(text, offset);
  if (!code) return unknown_escape(offset);
  offset += 6;
  if (*code >= 0xd800 && *code < 0xe000) {
    if (text.substr(offset).starts_with("\\u") && !code_at(text, offset)) return unknown_escape(offset);
    std::uint32_t second = code_at(text, offset).value_or(0);
    if (*code >= 0xdc00 || second < 0xdc00 || second >= 0xe000)
      return TokenFault{start,
                        "half a surrogate pair; expected \\uD800 to \\uDBFF and then \\uDC00 to \\uDFFF"};
    offset += 6;
    code = 0x10000 + ((*code - 0xd800) << 10) + (second - 0xdc00);
  }
  append_utf8(into, *code);
  return std::nullopt;
}

std::optional<TokenFault> read_escape(std::string_view text, std::size_t& offset, std::string& into) {
  constexpr std::string_view kNames = "\"\\/bfnrt", kMeanings = "\"\\/\b\f\n\r\t";
  char name = byte_at(text, offset + 1);
  if (name == 'u') return read_code(text, offset, into);
  std::size_t which = kNames.find(name);
  if (which == kNames.npos) return unknown_escape(offset);
  into += kMeanings[which];
  offset += 2;
  return std::nullopt;
}

/// Passes digits; whether there was one.
bool pass_digits(std::string_view text, std::size_t& offset) {
  std::size_t start = offset;
  while (is_digit(byte_at(text, offset))) ++offset;
  return offset > start;
}

/// Passes a number; whether it is finished.
bool pass_number(std::string_view text, std::size_t& offset, bool& integer) {
  if (byte_at(text, offset) == '-') ++offset;
  if (byte_at(text, offset) == '0') {
    ++offset;  // and no digit behind it
  } else if (!pass_digits(text, offset)) {
    return false;
  }
  integer = true;
  if (byte_at(text, offset) == '.') {
    integer = false;
    if (!pass_digits(text, ++offset)) return false;
  }
  if (byte_at(text, offset) == 'e' || byte_at(text, offset) == 'E') {
    integer = false;
    ++offset;
    if (byte_at(text, offset) == '+' || byte_at(text, offset) == '-') ++offset;
    if (!pass_digits(text, offset)) return false;
  }
  return true;
}

/// Whether a number that is beyond double precision is too large, not too small.
bool above_one(std::string_view number) {
  std::size_t e = std::min(number.find_first_of("eE"), number.size());
  std::string_view digits = number.substr(0, e), exponent = number.substr(std::min(e + 1, number.size()));
  bool negative = exponent.starts_with('-');
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  long power = 0;
  if (std::from_chars(exponent.data(), exponent.data() + exponent.size(), power).ec ==
      std::errc::result_out_of_range)
    return !negative;
  auto point = static_cast<long>(std::min(digits.find('.'), digits.size()));
  auto first = static_cast<long>(digits.find_first_of("123456789"));
  return power + (point - first) > 0;
}

}  // namespace

std::size_t skip_blanks(std::string_view text, std::size_t offset) {
  for (;;) {
    offset = std::min(text.find_first_not_of(" \t\r\n", offset), text.size());
    std::string_view rest = text.substr(offset);
    if (rest.starts_with("//")) {
      offset = std::min(text.find_first_of("\r\n", offset), text.size());
    } else if (rest.starts_with("/*") && rest.find("*/", 2) != rest.npos) {
      offset += rest.find("*/", 2) + 2;
    } else {
      return offset;
    }
  }
}

std::optional<TokenFault> read_quoted(std::string_view text, std::size_t& offset, std::string& into) {
  const std::size_t start = offset++;
  for (;;) {
    std::size_t run = offset;
    auto plain = [](char c) { return c != '"' && c != '\\' && static_cast<unsigned char>(c) >= 0x20; };
    while (offset < text.size() && plain(text[offset])) ++offset;
    into += text.substr(run, offset - run);
    if (offset == text.size()) return TokenFault{start, "a text without end; expected a closing '\"'"};
    if (text[offset] == '"') return ++offset, std::nullopt;
    if (text[offset] != '\\')
      return TokenFault{offset,
                        "a line break or control character inside a text; expected an escape such as \\n"};
    if (std::optional<TokenFault> fault = read_escape(text, offset, into)) return fault;
  }
}

std::optional<TokenFault> read_number(std::string_view text, std::size_t& offset, NumberToken& into) {
  const std::size_t start = offset;
  if (!pass_number(text, offset, into.integer))
    return TokenFault{start, "an unfinished number; expected a digit behind its '-', '.' or 'e'"};
  std::string_view number = text.substr(start, offset - start);
  double read = 0;
  if (std::from_chars(number.data(), number.data() + number.size(), read).ec != std::errc()) {
    if (above_one(number))
      return TokenFault{start, fmt::format("the number {:.40}; expected one below 1.8e308", number)};
    read = 0;
  }
  into.number = into.integer && read == 0 ? 0 : read;  // no -0
  return std::nullopt;
}

std::string found_at(std::string_view text, std::size_t offset) {
  std::string_view rest = text.substr(offset);
  if (rest.empty()) return "the end of the text";
  if (static_cast<unsigned char>(rest[0]) < 0x20) return "a control character";
  return fmt::format("'{}'", rest.substr(0, character_size(rest)));
}

}  // namespace frond
