#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/read_as.h"

namespace frond {

/// The first line of a text, without its end (CR, LF or both), which goes from the text with it.
inline std::string_view consume_line(std::string_view& text) {
  std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  text.remove_prefix(line.size());
  if (text.starts_with("\r\n"))
    text.remove_prefix(2);
  else if (!text.empty())
    text.remove_prefix(1);
  return line;
}

/// The lines of a text that some program wrote: they end as on any system, the text may begin with a byte
/// order mark and end at a Ctrl-Z, what follows a `#` is left out, and a line that ends with a backslash goes
/// on in the next.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : rest_(text) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
    rest_ = rest_.substr(0, rest_.find('\x1A'));
  }

  /// Takes the next line; false at the end.
  bool next() {
    if (rest_.empty()) return false;
    first_ = last_ + 1;
    line_ = next_line();
    if (!goes_on()) return true;
    joined_.clear();
    while (goes_on()) {
      joined_ += line_.substr(0, line_.find_last_of('\\'));
      joined_ += ' ';
      if (rest_.empty()) {
        line_ = {};
        break;
      }
      line_ = next_line();
    }
    joined_ += line_;
    line_ = joined_;
    return true;
  }

  std::string_view line() const { return line_; }
  int number() const { return first_; }  ///< from 1, of the first of those that were joined

  /// Takes the next word off the line; empty at its end.
  std::string_view word() {
    line_.remove_prefix(std::min(line_.find_first_not_of(kBlanks), line_.size()));
    std::string_view word = line_.substr(0, line_.find_first_of(kBlanks));
    line_.remove_prefix(word.size());
    return word;
  }

  /// All that is left of the line, without blanks round it.
  std::string_view others() {
    line_.remove_prefix(std::min(line_.find_first_not_of(kBlanks), line_.size()));
    line_ = line_.substr(0, line_.find_last_not_of(kBlanks) + 1);
    return std::exchange(line_, {});
  }

 private:
  static constexpr std::string_view kBlanks = " \t\v\f";

  std::string_view next_line() {
    ++last_;
    std::string_view line = consume_line(rest_);
    return line.substr(0, line.find('#'));
  }

  bool goes_on() const {
    std::size_t last = line_.find_last_not_of(kBlanks);
    return last != line_.npos && line_[last] == '\\';
  }

  std::string_view rest_, line_;
  std::string joined_;
  int first_ = 0, last_ = 0;
};

/// A word as a finite number of at most what a float holds, whatever the locale is; none if it is not one.
inline std::optional<double> number_of(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  std::optional<double> x = read_as<double>(word);
  return x && std::abs(*x) <= 3.4e38 ? x : std::nullopt;
}

}  // namespace frond
