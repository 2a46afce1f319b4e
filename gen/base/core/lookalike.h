#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace frond {

/// A character that looks like one of ASCII, as pages, word processors and keyboards of other alphabets put
/// it in its place: a minus sign, a full-width bracket, a curly quote, a blank that does not break.
struct Lookalike {
  std::size_t at = 0, size = 0;  ///< in the text, bytes
  std::string name;              ///< "`−` (U+2212)"; of a blank its code alone
  std::string meant;             ///< what it stands for: "`-`", "a blank"
};

/// The first sign or blank from `from` on that is one. Letters of other alphabets are none.
std::optional<Lookalike> find_lookalike(std::string_view text, std::size_t from = 0);

/// The letter of ASCII that a letter of another alphabet cannot be told from; 0 where there is none.
char latin_lookalike(std::string_view character);

/// The number of the letter at an offset, from 1: letters of several bytes count once.
std::size_t column_of(std::string_view text, std::size_t at);

}  // namespace frond
