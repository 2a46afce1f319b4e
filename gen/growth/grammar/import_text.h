#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/plain_text.h"
#include "core/result.h"

namespace frond {
struct GrammarText;
}

/// Functions shared by the readers of other tools' grammars.
namespace frond::import_text {

struct Line {
  std::string_view text;
  int number = 0;
  std::string_view whole = {};  ///< with its blanks
};

/// The lines that are not empty, trimmed, with their numbers.
std::vector<Line> lines_of(std::string_view text);

/// A finite number, nothing else.
std::optional<double> number(std::string_view text);

/// Where a part of a line stands: "line 3: column 5".
std::string place_in(const Line& line, std::string_view part);

/// The first sign of the line that looks like one of ASCII and is not, as an error.
std::optional<Error> odd_sign(const Line& line);

/// The error that the line's value is not a number from 0 to `most`.
Error not_a_count(const Line& line, double most);

/// A setting as a whole number: truncated, from 0 to `most`. Notes an error if it is none.
template <class T>
void read_count(T& out, std::optional<double> value, double most, const Line& line, Errors& errors) {
  if (value && *value >= 0 && *value < most + 1)
    out = static_cast<T>(*value);
  else
    errors.push_back(not_a_count(line, most));
}

inline constexpr double kMostSteps = 1e6, kMostSeed = 9e15, kMostMutations = 10'000;

/// Steps, a fraction of which says how far the last one has grown.
void read_steps(GrammarText& grammar, std::optional<double> given, const Line& line, Errors& errors);

/// Position of the last `sign` outside parentheses, or npos.
std::size_t last_outside(std::string_view text, char sign);

}  // namespace frond::import_text
