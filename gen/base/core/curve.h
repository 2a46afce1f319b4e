#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/ease.h"
#include "core/vec.h"

namespace frond {

/// Weights of a cubic Hermite segment at `t` in 0..1 for start value, start slope, end value and end slope.
struct Hermite {
  double start, start_slope, end, end_slope;
};
Hermite hermite(double t);

/// Slopes for a cubic through (x, y) without overshoot or ringing (Fritsch and Butland 1984): zero at every
/// local extreme and, with `flat_ends`, at both ends. `x` is strictly increasing and as long as `y`.
std::vector<double> monotone_slopes(std::span<const double> x, std::span<const double> y, bool flat_ends);

/// An editable curve: a smooth function through control points, constant beyond the first and the last,
/// always between neighbouring points. Points have strictly increasing x; no points mean the constant 1.
class Curve {
 public:
  Curve() = default;
  explicit Curve(std::vector<Vec2> points);

  double operator()(double x) const;
  const std::vector<Vec2>& points() const { return points_; }

 private:
  std::vector<Vec2> points_;
  std::vector<double> slopes_;
};

/// A value that may change over the film: a constant, or keyframes at increasing times (seconds), joined by
/// curves with continuous speed that rest at the first and the last key. Between two keys that is a cubic
/// Bézier curve, whose handles may be given in place of those of that speed. A key with an ease sets the pace
/// of the way to the next one, which is straight where it has no handles. `T` is `double` or `Vec3`.
template <class T>
class Animated {
 public:
  struct Key {
    double time;
    T value;
    std::optional<Ease> ease = {};  ///< of the way to the next key
    std::optional<T> in = {},
                     out = {};  ///< handles, from the value; one that is missing is opposite to the other

    bool handled() const { return in || out; }
    bool operator==(const Key&) const = default;
  };

  Animated(T constant = T{}) : Animated(std::vector<Key>{{0.0, constant}}) {}
  explicit Animated(std::vector<Key> keys);

  T at(double time) const;
  bool operator==(const Animated& other) const { return keys_ == other.keys_; }
  bool constant() const { return keys_.size() == 1; }
  const std::vector<Key>& keys() const { return keys_; }

 private:
  /// From key `i` on, when a share of the time to the next has passed.
  T shaped(std::size_t i, double share) const;

  std::vector<Key> keys_;
  std::vector<T> slopes_;
};

/// The largest value that it takes: between keys it is between their values.
double highest(const Animated<double>& value);

extern template class Animated<double>;
extern template class Animated<Vec3>;

}  // namespace frond
