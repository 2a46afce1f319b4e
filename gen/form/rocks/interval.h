#pragma once

#include <algorithm>

namespace frond {

/// All numbers from low to high: interval arithmetic (Moore 1966).
struct Interval {
  double low = 0, high = 0;
  bool holds(double x) const { return low <= x && x <= high; }
};

constexpr Interval operator+(Interval a, Interval b) { return {a.low + b.low, a.high + b.high}; }
constexpr Interval operator+(Interval a, double b) { return {a.low + b, a.high + b}; }

constexpr Interval operator*(Interval a, double b) {
  return b < 0 ? Interval{a.high * b, a.low * b} : Interval{a.low * b, a.high * b};
}

constexpr Interval operator*(Interval a, Interval b) {
  double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  return {std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s))};
}

/// The squares of all numbers of an interval; tighter than multiplying it by itself.
constexpr Interval squared(Interval a) {
  double p = a.low * a.low, q = a.high * a.high;
  if (a.low <= 0 && a.high >= 0) return {0, std::max(p, q)};
  return {std::min(p, q), std::max(p, q)};
}

/// Widened by `share` of its magnitude on both sides, to cover rounding.
constexpr Interval widened(Interval a, double share) {
  double by = share * (std::max(-a.low, a.high) + 1);
  return {a.low - by, a.high + by};
}

}  // namespace frond
