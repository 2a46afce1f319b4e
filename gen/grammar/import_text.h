#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What readers of other tools' grammars share.
namespace frond::import_text {

struct Line {
  std::string_view text;
  int number = 0;
};

/// Without blanks at its ends.
std::string_view trim(std::string_view text);

/// The lines that are not empty, trimmed, with their numbers.
std::vector<Line> lines_of(std::string_view text);

/// The text without `/* … */`.
std::string without_comments(std::string_view text);

std::optional<double> number(std::string_view text);

/// The last place of a sign outside parentheses, or npos.
std::size_t last_outside(std::string_view text, char sign);

/// Every `name` that is not the end of a longer word, replaced.
std::string replaced(std::string text, std::string_view name, std::string_view by);

}  // namespace frond::import_text
