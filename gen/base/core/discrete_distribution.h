#pragma once

#include <algorithm>
#include <vector>

namespace frond {

/// Draws from things that have weights; the chance of each is its share of all weight.
class DiscreteDistribution {
 public:
  /// Appends one; without weight it is never drawn.
  void add(double weight) { sums_.push_back(sum() + weight); }
  double sum() const { return sums_.empty() ? 0 : sums_.back(); }
  /// The number of one, by a number of 0..1: the last where nothing has weight. There is at least one.
  std::size_t drawn(double lot) const {
    auto found = std::ranges::upper_bound(sums_, lot * sum()) - sums_.begin();
    return std::min(static_cast<std::size_t>(found), sums_.size() - 1);
  }

 private:
  std::vector<double> sums_;  // of the weights up to and with each
};

}  // namespace frond
