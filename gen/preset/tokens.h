#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace frond {

// The tokens of a JSON text with comments (RFC 8259, and `//` and `/* */` wherever blanks may stand). What a
// token is worth where it stands is judged by parse_json().

/// The first offset from `offset` on that is neither blank nor within a comment: where the next token begins,
/// or the end of the text. At a comment without end, where that begins.
std::size_t skip_blanks(std::string_view text, std::size_t offset);

/// What is wrong within a token: `found; expected ...`
struct TokenFault {
  std::size_t offset = 0;
  std::string what;
};

/// Reads the text in double quotes that begins at `offset`, which comes to stand behind it, and appends what
/// it means to `into`. The text around is UTF-8.
std::optional<TokenFault> read_quoted(std::string_view text, std::size_t& offset, std::string& into);

struct NumberToken {
  double number = 0;
  bool integer = false;  ///< written without fraction and exponent
};

/// Reads the number that begins at `offset` with a digit or '-', as read_quoted() does. Numbers too small for
/// double precision are 0.
std::optional<TokenFault> read_number(std::string_view text, std::size_t& offset, NumberToken& into);

/// What begins at `offset`, as a message names it: `'x'`, `the end of the text`, `a control character`.
std::string found_at(std::string_view text, std::size_t offset);

}  // namespace frond
