#include "core/curve.h"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "core/spline.h"

namespace frond {

Hermite hermite(double t) {
  double s = 1 - t;
  return {(1 + 2 * t) * s * s, t * s * s, t * t * (3 - 2 * t), -t * t * s};
}

std::vector<double> monotone_slopes(std::span<const double> x, std::span<const double> y, bool flat_ends) {
  assert(x.size() == y.size());
  std::size_t n = x.size();
  std::vector<double> slopes(n, 0.0);
  if (n < 2) return slopes;

  auto secant = [&](std::size_t i) { return (y[i + 1] - y[i]) / (x[i + 1] - x[i]); };
  for (std::size_t i = 1; i + 1 < n; ++i) {
    double before = secant(i - 1), after = secant(i);
    if (before * after <= 0) continue;
    double h0 = x[i] - x[i - 1], h1 = x[i + 1] - x[i];
    double weight = (h0 + 2 * h1) / (3 * (h0 + h1));
    slopes[i] = before * after / (weight * after + (1 - weight) * before);
  }
  if (!flat_ends) {
    // Three-point ends, held to the range in which a cubic stays monotone.
    auto end = [](double near, double inner) {
      double slope = (3 * near - inner) / 2;
      return slope * near <= 0 ? 0.0 : (near > 0 ? std::min(slope, 3 * near) : std::max(slope, 3 * near));
    };
    slopes[0] = end(secant(0), slopes[1]);
    slopes[n - 1] = end(secant(n - 2), slopes[n - 2]);
    if (n == 2) slopes[0] = slopes[1] = secant(0);
  }
  return slopes;
}

Curve::Curve(std::vector<Vec2> points) : points_(std::move(points)) {
  std::vector<double> x, y;
  for (Vec2 p : points_) {
    assert(x.empty() || p.x > x.back());
    x.push_back(p.x);
    y.push_back(p.y);
  }
  slopes_ = monotone_slopes(x, y, false);
}

double Curve::operator()(double x) const {
  if (points_.empty()) return 1;
  if (x <= points_.front().x) return points_.front().y;
  if (x >= points_.back().x) return points_.back().y;
  auto after = std::upper_bound(points_.begin(), points_.end(), x, [](double v, Vec2 p) { return v < p.x; });
  std::size_t i = static_cast<std::size_t>(after - points_.begin()) - 1;
  double width = points_[i + 1].x - points_[i].x;
  Hermite w = hermite((x - points_[i].x) / width);
  return w.start * points_[i].y + w.start_slope * width * slopes_[i] + w.end * points_[i + 1].y +
         w.end_slope * width * slopes_[i + 1];
}

namespace {

int components(double) { return 1; }
int components(const Vec3&) { return 3; }
double& component(double& v, int) { return v; }
float& component(Vec3& v, int i) { return v[i]; }

}  // namespace

template <class T>
Animated<T>::Animated(std::vector<Key> keys) : keys_(std::move(keys)), slopes_(keys_.size(), T{}) {
  assert(!keys_.empty());
  std::vector<double> x, y(keys_.size());
  for (const Key& key : keys_) {
    assert(x.empty() || key.time > x.back());
    x.push_back(key.time);
  }
  for (int c = 0; c < components(T{}); ++c) {
    for (std::size_t i = 0; i < keys_.size(); ++i) y[i] = component(keys_[i].value, c);
    std::vector<double> slopes = monotone_slopes(x, y, true);
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      auto& slope = component(slopes_[i], c);
      slope = static_cast<std::remove_reference_t<decltype(slope)>>(slopes[i]);
    }
  }
}

template <class T>
T Animated<T>::shaped(std::size_t i, double share) const {
  using Scalar = std::conditional_t<std::is_same_v<T, double>, double, float>;
  const Key &a = keys_[i], &d = keys_[i + 1];
  auto handle = [&](const Key& key, const T& slope, bool on) -> T {
    if (key.handled()) return on ? handle_of(key.out, key.in) : handle_of(key.in, key.out);
    T third = (a.ease ? d.value - a.value : static_cast<Scalar>(d.time - a.time) * slope) / Scalar{3};
    return on ? third : -third;
  };
  T b = a.value + handle(a, slopes_[i], true), c = d.value + handle(d, slopes_[i + 1], false);
  return cubic_place(a.value, b, c, d.value, static_cast<Scalar>(a.ease ? eased(*a.ease, share) : share));
}

template <class T>
T Animated<T>::at(double time) const {
  if (time <= keys_.front().time) return keys_.front().value;
  if (time >= keys_.back().time) return keys_.back().value;
  auto after = std::ranges::upper_bound(keys_, time, {}, &Key::time);
  auto before = std::prev(after);
  double width = after->time - before->time;
  if (before->ease || before->handled() || after->handled())
    return shaped(static_cast<std::size_t>(before - keys_.begin()), (time - before->time) / width);
  Hermite w = hermite((time - before->time) / width);
  const T& slope_before = slopes_[before - keys_.begin()];
  const T& slope_after = slopes_[after - keys_.begin()];
  using Scalar = std::conditional_t<std::is_same_v<T, double>, double, float>;
  return static_cast<Scalar>(w.start) * before->value + static_cast<Scalar>(w.end) * after->value +
         static_cast<Scalar>(w.start_slope * width) * slope_before +
         static_cast<Scalar>(w.end_slope * width) * slope_after;
}

double highest(const Animated<double>& value) {
  return std::ranges::max(value.keys(), {}, &Animated<double>::Key::value).value;
}

template class Animated<double>;
template class Animated<Vec3>;

}  // namespace frond
