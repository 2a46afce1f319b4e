#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace frond {

// Where the tokens of a JSON text stand, and what is wrong where one is not as it must be. The text itself is
// read by a library; parse_json() puts the two together.

/// The first offset from `offset` on that is neither blank nor within a comment: where the next token begins,
/// or the end of the text. At a comment without end, where that begins.
std::size_t skip_blanks(std::string_view text, std::size_t offset);

/// What must follow the last token that was right.
enum class Expected {
  value,             ///< at the beginning of the text or of a list
  first_name,        ///< at the beginning of an object
  colon,             ///< behind a name
  comma_or_bracket,  ///< behind an element of a list
  comma_or_brace,    ///< behind a member of an object
  end                ///< behind all
};

struct SyntaxFault {
  std::size_t offset = 0;
  bool inside = false;  ///< it is about the next element or member, not the list or object that has it
  std::string what;     ///< `found; expected ...`
};

/// What is wrong behind `offset`, the end of the last token that was right. `position` (bytes read) and
/// `reason` are what the library says of it.
SyntaxFault find_fault(std::string_view text, std::size_t offset, Expected expected, std::size_t position,
                       std::string_view reason);

}  // namespace frond
