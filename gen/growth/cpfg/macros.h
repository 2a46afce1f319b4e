#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace frond::cpfg {

/// A macro; with arguments where `is_function`.
struct MacroText {
  bool is_function = false;
  std::vector<std::string> parameters;
  std::string body;
};

/// The macros that are defined, and how to replace them. After an error, in `error`, nothing is replaced.
struct MacroTable {
  std::map<std::string, MacroText, std::less<>> macros;
  std::string error;
  std::size_t produced = 0;  ///< bytes of text that macros became
  std::size_t depth = 0;     ///< how deep macros stand in each other now

  /// The text with all macros replaced, and those in what they became, but none within itself. Strings stay.
  std::string expanded(std::string_view text);
  /// Whether the text ends within the arguments of a macro, so that they go on in the next line.
  bool is_open(std::string_view text) const;
  /// Whether the text ends with the name of a macro that takes arguments.
  bool ends_in_call(std::string_view text) const;
  /// Reads what follows `#define`.
  void define(std::string_view text);

 private:
  std::string expand(std::string_view text, std::set<std::string, std::less<>>& within);
  std::string substitute(const std::string& name, const std::vector<std::string>& arguments,
                         std::set<std::string, std::less<>>& within);
};

bool is_name_letter(char c);
/// The length of the run of letters, digits and `_` that the text begins with.
std::size_t name_length(std::string_view text);
/// The length of the string that the text begins with, quotes included; 0 if not closed in its line.
std::size_t string_length(std::string_view text);

}  // namespace frond::cpfg
