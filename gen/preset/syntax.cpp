#include "preset/syntax.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/utf8.h"

namespace frond {
namespace {

/// A fault within a token. The library tells it by a sentence of its own, which stands for one of ours, and
/// is found at the token itself, at the last byte read or at the escape before that.
struct TokenFault {
  enum class Spot { token, byte, escape };

  std::string_view reason;  ///< part of the library's sentence
  Spot spot;
  std::string_view what;
};

constexpr std::string_view kEscapes = R"(an unknown escape; expected one of \" \\ \/ \b \f \n \r \t \uXXXX)";

constexpr TokenFault kTokenFaults[] = {
    {"missing closing quote", TokenFault::Spot::token, "a text without end; expected a closing '\"'"},
    {"control character", TokenFault::Spot::byte,
     "a line break or control character inside a text; expected an escape such as \\n"},
    {"after backslash", TokenFault::Spot::escape, kEscapes},
    {"hex digits", TokenFault::Spot::escape, kEscapes},
    {"surrogate", TokenFault::Spot::escape,
     "half a surrogate pair; expected \\uD800 to \\uDBFF and then \\uDC00 to \\uDFFF"},
    {"invalid number", TokenFault::Spot::token,
     "an unfinished number; expected a digit behind its '-', '.' or 'e'"},
};

/// A fault at what stands at `offset`, where something else is expected.
SyntaxFault unexpected(std::string_view text, std::size_t offset, bool inside, std::string_view expected) {
  std::string_view rest = text.substr(offset);
  std::string found = fmt::format("'{}'", rest.substr(0, character_size(rest)));
  if (rest.starts_with("/*")) {
    found = "a comment without end";
    expected = "*/";
  } else if (rest.empty()) {
    found = "the end of the text";
  } else if (static_cast<unsigned char>(rest[0]) < 0x20) {
    found = "a control character";
  }
  return {offset, inside, fmt::format("{}; expected {}", found, expected)};
}

/// A fault in or at the token that begins at `offset`.
SyntaxFault token_fault(std::string_view text, std::size_t offset, bool inside, std::string_view expected,
                        std::size_t position, std::string_view reason) {
  position = std::clamp(position, offset, text.size());
  if (reason.find("number overflow") != reason.npos) {
    std::string_view number = text.substr(offset, position - offset);
    return {offset, inside, fmt::format("the number {:.40}; expected one below 1.8e308", number)};
  }
  // The library goes on to quote the text, which may hold anything.
  reason = reason.substr(0, reason.find("; last read"));
  for (const TokenFault& fault : kTokenFaults) {
    if (reason.find(fault.reason) == reason.npos) continue;
    std::size_t byte = std::max(position, offset + 1) - 1;
    std::size_t escape = text.rfind('\\', std::max(byte, offset + 1) - 1);
    switch (fault.spot) {
      case TokenFault::Spot::token:
        break;
      case TokenFault::Spot::byte:
        offset = byte;
        break;
      case TokenFault::Spot::escape:
        offset = escape == text.npos ? offset : std::max(escape, offset);
        break;
    }
    return {offset, inside, std::string(fault.what)};
  }
  return unexpected(text, offset, inside, expected);
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

SyntaxFault find_fault(std::string_view text, std::size_t offset, Expected expected, std::size_t position,
                       std::string_view reason) {
  const std::size_t end = offset;
  offset = skip_blanks(text, offset);
  auto here = [&] { return offset < text.size() ? text[offset] : '\0'; };
  auto value_fault = [&] { return token_fault(text, offset, true, "a value", position, reason); };
  auto name_fault = [&] {
    std::string_view name = "a name in double quotes";
    if (here() != '"') return unexpected(text, offset, false, name);
    return token_fault(text, offset, false, name, position, reason);
  };
  // Where the next member or element begins, its comma is missing: right behind the value, which may be lines
  // above.
  auto no_comma = [&](std::string_view beginnings, std::string_view expected_there) {
    if (here() == '\0' || beginnings.find(here()) == beginnings.npos)
      return unexpected(text, offset, false, expected_there);
    return SyntaxFault{end, false, fmt::format("no comma behind the value; expected {}", expected_there)};
  };
  // Behind the comma, if there is one: whether the closing bracket follows it.
  std::size_t comma = offset;
  auto ends_behind_comma = [&](char close) {
    offset = skip_blanks(text, comma + 1);
    return here() == close;
  };

  switch (expected) {
    case Expected::value:
      return value_fault();
    case Expected::first_name:
      return name_fault();
    case Expected::colon:
      if (here() != ':') return unexpected(text, offset, false, "':' behind the name");
      offset = skip_blanks(text, offset + 1);
      return value_fault();
    case Expected::comma_or_bracket:
      if (here() != ',') return no_comma("\"{[-0123456789tfn", "',' or ']'");
      if (!ends_behind_comma(']')) return value_fault();
      return {comma, false, "a comma before the closing ']'; expected no comma behind the last element"};
    case Expected::comma_or_brace:
      if (here() != ',') return no_comma("\"", "',' or '}'");
      if (!ends_behind_comma('}')) return name_fault();
      return {comma, false, "a comma before the closing '}'; expected no comma behind the last member"};
    case Expected::end:
      break;
  }
  return unexpected(text, offset, false, "the end of the text");
}

}  // namespace frond
