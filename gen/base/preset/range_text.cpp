#include "preset/range_text.h"

#include <fmt/format.h>

#include "preset/json.h"

namespace frond {

namespace {

std::string bounds_text(const Range& range) {
  auto digits = [](double x) { return serialize(make_number(x)); };
  std::string unit = range.unit.empty() ? "" : fmt::format(" {}", range.unit);
  constexpr double kNatural = 1e30;  // beyond it a bound is that of float or double
  bool from = range.min > -kNatural;
  bool to = range.max < kNatural;
  if (from && to) {
    std::string_view first = range.above_min ? "above" : "from";
    return fmt::format(" {} {} {} {}{}", first, digits(range.min), range.above_min ? "up to" : "to",
                       digits(range.max), unit);
  }
  if (from)
    return fmt::format(" {} {}{}", range.above_min ? "above" : "of at least", digits(range.min), unit);
  if (to) return fmt::format(" of at most {}{}", digits(range.max), unit);
  return range.unit.empty() ? "" : fmt::format(" ({})", range.unit);
}

}  // namespace

std::string range_text(const Range& range) {
  return bounds_text(range) + (range.sense.empty() ? "" : fmt::format(" ({})", range.sense));
}

}  // namespace frond
