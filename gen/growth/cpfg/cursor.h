#pragma once

#include <string>
#include <string_view>

namespace frond::cpfg {

/// A place in a grammar. A newline ends an item unless a tab follows or it stands in the braces of a
/// statement block; blanks and tabs are passed over.
class GrammarCursor {
 public:
  explicit GrammarCursor(std::string_view text) : text_(text) {}

  /// Whether newlines are blanks now.
  bool in_braces = false;

  /// The next character after blanks: '\n' at the end of an item, 0 at the end of all.
  char peek() {
    skip();
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool at_item_end() { return peek() == '\n' || at_ >= text_.size(); }
  /// The character here, without passing blanks over.
  char here(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  bool is_next(std::string_view word) {
    skip();
    return text_.substr(at_).starts_with(word);
  }
  bool consume(std::string_view word) {
    if (!is_next(word)) return false;
    at_ += word.size();
    return true;
  }
  char read_char() { return at_ < text_.size() ? text_[at_++] : '\0'; }
  std::size_t position() const { return at_; }
  void go_to(std::size_t position) { at_ = position; }
  std::string_view rest() const { return text_.substr(at_); }
  bool at_end() const { return at_ >= text_.size(); }
  /// Passes over all blanks and empty lines, to where an item begins.
  void skip_to_item() {
    while (at_ < text_.size() && (is_blank(text_[at_]) || text_[at_] == '\n')) ++at_;
  }
  /// The rest of the line, which is passed over.
  std::string_view read_line() {
    std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view line = text_.substr(at_, end - at_);
    at_ = end;
    return line;
  }
  void go_to_end() { at_ = text_.size(); }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v'; }
  void skip() {
    for (; at_ < text_.size(); ++at_) {
      bool newline = text_[at_] == '\n' && (in_braces || (at_ + 1 < text_.size() && text_[at_ + 1] == '\t'));
      if (!is_blank(text_[at_]) && !newline) return;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace frond::cpfg
