#pragma once

#include <algorithm>

namespace frond {

/// All numbers from low to high: interval arithmetic (Moore 1966).
struct Range {
  double low = 0, high = 0;
  bool holds(double x) const { return low <= x && x <= high; }
};

constexpr Range operator+(Range a, Range b) { return {a.low + b.low, a.high + b.high}; }
constexpr Range operator+(Range a, double b) { return {a.low + b, a.high + b}; }

constexpr Range operator*(Range a, double b) {
  return b < 0 ? Range{a.high * b, a.low * b} : Range{a.low * b, a.high * b};
}

constexpr Range operator*(Range a, Range b) {
  double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  return {std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s))};
}

/// The squares of all numbers of a range; tighter than the product of it with itself.
constexpr Range squared(Range a) {
  double p = a.low * a.low, q = a.high * a.high;
  if (a.low <= 0 && a.high >= 0) return {0, std::max(p, q)};
  return {std::min(p, q), std::max(p, q)};
}

/// Wider by `share` of its magnitude on both sides, for what rounding may have taken.
constexpr Range widened(Range a, double share) {
  double by = share * (std::max(-a.low, a.high) + 1);
  return {a.low - by, a.high + by};
}

}  // namespace frond
