#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace frond {

/// Appends a number in the common format of all texts we write: at most `decimals` (0 to 9) decimals, rounded
/// half away from zero, no trailing zeros, no exponent, never "-0", no locale. Values beyond 9e18 /
/// 10^decimals are clamped to it, and NaN becomes 0; models contain neither.
void append(std::string& text, double value, int decimals = 5);

/// A number as a new string, in the format of append().
std::string number_text(double value, int decimals = 5);

/// Appends a whole number.
void append_integer(std::string& text, long long value);
inline void append_index(std::string& text, std::size_t index) {
  append_integer(text, static_cast<long long>(index));
}

/// Appends `<x, y, z>`-style lists: the numbers with `,` between them.
template <class... Numbers>
void append_list(std::string& text, int decimals, double first, Numbers... rest) {
  append(text, first, decimals);
  ((text += ',', append(text, static_cast<double>(rest), decimals)), ...);
}

/// The parts of a text between separators, or ended by them.
std::vector<std::string> split(std::string_view text, char separator);

/// The text as a whole number from 1 on; 0 if it is none or too large.
int counting_number(std::string_view text);
/// Consumes a whole number from 0 on at the front of a text; 0 where there is none.
int consume_whole(std::string_view& text);

/// A receiver of a long text in pieces.
using Out = std::function<void(std::string_view)>;

/// Writes a template; at each `{{name}}` it calls `hole(name)` to write the replacement. Replacements are not
/// searched for holes.
template <class Hole>
void fill(std::string_view layout, const Out& out, const Hole& hole) {
  for (;;) {
    std::size_t open = layout.find("{{");
    std::size_t close = open == layout.npos ? open : layout.find("}}", open);
    out(layout.substr(0, close == layout.npos ? layout.npos : open));
    if (close == layout.npos) return;
    hole(layout.substr(open + 2, close - open - 2));
    layout.remove_prefix(close + 2);
  }
}

/// A text with the letters of ASCII in small ones.
std::string lower_case(std::string_view text);

/// Number of edits (insert, delete, replace, swap neighbours) between two names; case is ignored.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to a misspelt `name` (Damerau-Levenshtein), or empty where none is near enough.
template <class Names>
std::string_view nearest_name(std::string_view name, const Names& candidates) {
  std::string_view best;
  std::size_t best_distance = 2 + name.size() / 4;
  for (std::string_view candidate : candidates) {
    std::size_t distance = edit_distance(name, candidate);
    if (distance < best_distance && distance < candidate.size()) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace frond
