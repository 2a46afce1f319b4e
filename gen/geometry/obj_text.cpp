#include "geometry/obj_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace frond {

namespace {

/// Takes the next word off a line; empty at its end.
std::string_view next_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  std::string_view word = line.substr(0, line.find_first_of(" \t"));
  line.remove_prefix(word.size());
  return word;
}

bool is_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double x = 0;
  auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), x);
  return error == std::errc{} && end == word.data() + word.size() && std::isfinite(x) &&
         std::abs(x) <= std::numeric_limits<float>::max();
}

/// How many there are of something, and the furthest of them that was named before it was given.
struct Supply {
  std::string_view what;
  long long count = 0, wanted = 0;
  int line = 0;  ///< on which that was

  /// Whether a corner may name that one: by its number from 1, or counted back from the last.
  bool take(std::string_view digits, int at) {
    long long index = 0;
    auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (error != std::errc{} || end != digits.data() + digits.size() || index == 0 || index < -count)
      return false;
    if (index > count && index > wanted) wanted = index, line = at;
    return true;
  }
};

class Checker {
 public:
  explicit Checker(const std::string& name) : name_(name) {}

  Errors check(std::string_view text) {
    while (!text.empty()) {
      ++line_;
      std::string_view line = text.substr(0, text.find('\n'));
      text.remove_prefix(std::min(line.size() + 1, text.size()));
      if (line.ends_with('\r')) line.remove_suffix(1);
      std::string wrong = line_fault(line);
      if (!wrong.empty()) return fault(line_, wrong);
    }
    for (const Supply* supply : {&places_, &normals_})
      if (supply->wanted > supply->count) return fault(supply->line, missing(*supply));
    return {};
  }

 private:
  Errors fault(int line, std::string what) const {
    return {{fmt::format("{}:{}", name_, line), std::move(what)}};
  }

  static std::string missing(const Supply& supply) {
    return fmt::format("a corner names a {} that is not there; expected one of the {} that the file has",
                       supply.what, supply.count);
  }

  std::string line_fault(std::string_view line) {
    std::string_view kind = next_word(line);
    if (kind == "v") return ++places_.count, numbers_fault(line, "place");
    if (kind == "vn") return ++normals_.count, numbers_fault(line, "normal");
    if (kind == "f") return corners_fault(line, "face", 3);
    if (kind == "l") return corners_fault(line, "line", 2);
    return {};
  }

  static std::string numbers_fault(std::string_view line, std::string_view what) {
    for (int i = 0; i < 3; ++i)
      if (!is_number(next_word(line)))
        return fmt::format("a {} whose number {} is none; expected three finite numbers", what, i + 1);
    return {};
  }

  /// Of corners as `place`, `place/picture`, `place//normal` or `place/picture/normal`.
  std::string corners_fault(std::string_view line, std::string_view what, int least) {
    int count = 0;
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
      ++count;
      std::size_t slash = std::min(word.find('/'), word.size());
      std::size_t second = word.find('/', std::min(slash + 1, word.size()));
      if (!places_.take(word.substr(0, slash), line_)) return missing(places_);
      std::string_view normal = word.substr(std::min(second, word.size() - 1) + 1);
      if (second != word.npos && !normal.empty() && !normals_.take(normal, line_)) return missing(normals_);
    }
    if (count >= least) return {};
    return fmt::format("a {} of {} corners; expected {} or more", what, count, least);
  }

  const std::string& name_;
  int line_ = 0;
  Supply places_{"place"}, normals_{"normal"};
};

}  // namespace

Errors check_obj(std::string_view text, const std::string& name) { return Checker(name).check(text); }

}  // namespace frond
