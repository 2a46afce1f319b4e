#include "crown/along.h"

#include <algorithm>
#include <array>

namespace frond {

namespace {

constexpr std::size_t kSteps = 256;

/// How much lies below each of the places that cut a stretch into steps of one length.
std::array<double, kSteps + 1> sums(const Curve& density, double from, double to) {
  std::array<double, kSteps + 1> sum{};
  for (std::size_t i = 0; i < kSteps; ++i)
    sum[i + 1] = sum[i] + factor_along(density, from + (to - from) * (static_cast<double>(i) + 0.5) / kSteps);
  return sum;
}

}  // namespace

bool is_even(const Curve& curve) {
  return std::ranges::all_of(curve.points(), [](Vec2 point) { return point.y == 1; });
}

double factor_along(const Curve& curve, double place) {
  return is_even(curve) ? 1 : std::max(curve(place), 0.0);
}

double mean_along(const Curve& curve, double from, double to) {
  return is_even(curve) ? 1 : sums(curve, from, to).back() / kSteps;
}

double place_by_density(const Curve& density, double from, double to, double share) {
  if (is_even(density)) return from + (to - from) * share;
  const std::array<double, kSteps + 1> sum = sums(density, from, to);
  const double due = share * sum.back();
  const auto above = std::upper_bound(sum.begin(), sum.end() - 1, due);
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - sum.begin() - 1, 0));
  const double step = sum[i + 1] - sum[i];
  const double within = step > 0 ? std::min((due - sum[i]) / step, 1.0) : 0;
  return from + (to - from) * (static_cast<double>(i) + within) / kSteps;
}

}  // namespace frond
