#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace frond {

/// Appends a number as every text we write has it: at most `decimals` (0 to 9) decimals, rounded half away
/// from zero, no trailing zeros, no exponent, never "-0", no locale. Beyond 9e18 / 10^decimals that bound is
/// written, and 0 for what is no number: models hold neither.
void append(std::string& text, double value, int decimals = 5);

/// The same as a text of its own.
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

/// The parts of a text that a character ends or separates.
std::vector<std::string> split(std::string_view text, char separator);

/// Where a long text goes, piece by piece.
using Out = std::function<void(std::string_view)>;

/// Writes a template, with `hole(name)` called to write what stands in its place at each `{{name}}`. What is
/// filled in is not searched for holes.
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

/// The candidate that is nearest to a misspelt `name` (Damerau-Levenshtein), or empty where none is near
/// enough to be meant.
template <class Names>
std::string_view nearest_name(std::string_view name, const Names& candidates);

/// Edits (insert, delete, replace, swap neighbours) that turn one name into the other, letter case ignored.
std::size_t edit_distance(std::string_view a, std::string_view b);

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
