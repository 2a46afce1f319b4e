#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace frond {

// Tokens of a JSON text with comments (RFC 8259, with `//` and `/* */` wherever blanks are allowed).
// parse_json() checks whether a token is valid at its position.

/// The first offset from `offset` on that is neither blank nor in a comment: the start of the next token, or
/// the end of the text. For an unclosed comment, its start.
std::size_t skip_blanks(std::string_view text, std::size_t offset);

/// What is wrong within a token: `found; expected ...`
struct TokenFault {
  std::size_t offset = 0;
  std::string what;
};

/// Reads the quoted text that begins at `offset`, sets `offset` behind it, and appends the decoded text to
/// `into`. The source is valid UTF-8.
std::optional<TokenFault> read_quoted(std::string_view text, std::size_t& offset, std::string& into);

struct NumberToken {
  double number = 0;
  bool integer = false;  ///< written without fraction and exponent
};

/// Reads the number that begins at `offset` with a digit or '-', like read_quoted(). Numbers too small for
/// double precision become 0.
std::optional<TokenFault> read_number(std::string_view text, std::size_t& offset, NumberToken& into);

/// The character at `offset` as named in messages: `'x'`, `the end of the text`, `a control character`.
std::string found_at(std::string_view text, std::size_t offset);

}  // namespace frond
