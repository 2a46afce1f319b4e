#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace frond {

/// Offset of the first byte that is not UTF-8 (overlong forms and surrogates count as such).
std::optional<std::size_t> invalid_utf8(std::string_view text);

/// The tokens of a JSON text and their places; parse_json() puts them together.
class Scanner {
 public:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// Line and column from 1; a column is a character (code point), `\n` ends a line.
  struct Place {
    int line = 1;
    int column = 1;
  };

  struct Number {
    std::string_view text;  ///< empty where no number stands
    bool integer = true;    ///< neither fraction nor exponent
    bool tiny = false;      ///< below 1
  };

  struct TextFault {
    std::size_t offset = 0;
    std::string_view what;  ///< empty: no fault
  };

  /// A byte order mark at the beginning is passed over.
  explicit Scanner(std::string_view text);

  std::string_view text() const { return text_; }
  std::size_t offset() const { return offset_; }
  bool at_end() const { return offset_ == text_.size(); }
  /// The next byte, or 0 at the end.
  char peek() const { return at_end() ? '\0' : text_[offset_]; }
  void advance(std::size_t bytes) { offset_ += bytes; }

  /// Cheap for offsets that grow from call to call.
  Place place(std::size_t offset);

  /// Passes over blanks and comments; the offset of a comment without end, or kNone.
  std::size_t skip_blanks();

  /// The lower-case word that stands here, and the number that does; neither is passed over.
  std::string_view word() const;
  Number number() const;

  /// Passes over a quoted text and gives what it says.
  TextFault read_text(std::string& text);

  /// What stands here, for messages: `'x'`, `the end of the text`.
  std::string next_text() const;

 private:
  TextFault read_escape(std::string& text);
  std::optional<unsigned> hex4(std::size_t at) const;

  std::string_view text_;
  std::size_t offset_ = 0;
  std::size_t placed_offset_ = 0;
  Place placed_;
};

}  // namespace frond
