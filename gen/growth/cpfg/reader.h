#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "cpfg/code.h"
#include "cpfg/preprocess.h"

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

/// Reads a grammar that the preprocessor has gone over. The first mistake ends it.
class GrammarReader {
 public:
  GrammarReader(const PlainText& text, Code& code) : plain_(text), cursor_(text.text), code_(code) {}

  /// Reads all L-systems into the code.
  void read();

  const std::optional<Error>& error() const { return error_; }
  std::vector<std::string> notes;

 private:
  /// What a name may stand for here.
  struct Scope {
    std::vector<std::string> formals;
    std::vector<std::pair<std::string, int>> locals;
    bool keeps_locals = false;  ///< in a production; elsewhere new names belong to the L-system
  };

  // read_formula.cpp
  int read_formula();
  int read_choice();
  int read_binary(int strength);
  int read_unary();
  int read_primary();
  int read_number();
  int read_name();
  int read_call(std::string_view name, std::size_t from);
  int read_element(int array, std::size_t from);
  /// Formulas between commas to the closing sign, as a run in Code::lists; true where it is closed.
  bool read_list(char closing, std::vector<int>& nodes);
  int add(FormulaNode node);
  int add_list(const std::vector<int>& nodes);
  int slot_of(std::string_view name, FormulaKind& kind);
  int array_of(std::string_view name) const;
  std::string_view consume_name();

  // read_block.cpp
  int read_block();
  void read_statement(std::vector<Statement>& statements);
  void read_assignment(std::vector<Statement>& statements);
  int read_loop_condition();
  void read_define();
  void read_array();
  void read_initial(std::vector<int>& formulas, int depth);
  void read_external();

  // read_words.cpp
  std::vector<ModuleText> read_word(bool is_axiom);
  std::vector<PatternModule> read_pattern();
  void read_formals(PatternModule& module);
  bool at_arrow();
  void read_production(ProductionSet& set);
  void read_condition(CpfgProduction& production);
  void note_needless(const ProductionSet& set, const CpfgProduction& production);

  // reader.cpp
  void read_system();
  bool read_item(CpfgSystem& system);
  bool read_section_item(ProductionSet& set);
  bool consume_key(std::string_view words, std::string_view capitals = {});
  bool consume_section(std::string_view word, bool has_productions = false);
  void read_characters(CpfgSystem& system, bool considered);
  std::int64_t read_whole(std::string_view what);
  void end_item(std::string_view after);
  void fail(std::string what) { fail_at(cursor_.position(), std::move(what)); }
  std::string where(std::size_t position);
  int add_place(std::size_t position);  ///< its index in Code::places
  void fail_at(std::size_t position, std::string what);
  std::string found();
  bool failed() const { return error_.has_value(); }

  const PlainText& plain_;
  GrammarCursor cursor_;
  Code& code_;
  CpfgSystem* system_ = nullptr;
  ProductionSet* section_ = nullptr;
  Scope scope_;
  std::size_t counted_ = 0, counted_lines_ = 0;  ///< lines before the place that was asked for last
  int depth_ = 0;                                ///< how deep formulas and blocks stand in each other
  int formula_depth_ = 0;                        ///< how deep formulas do
  std::size_t formula_start_ = 0;
  std::optional<Error> error_;
};

}  // namespace frond::cpfg
