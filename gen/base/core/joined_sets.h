#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <numeric>
#include <vector>

namespace frond {

/// Numbers in sets that are joined by and by; the least number of a set stands for all of it.
class JoinedSets {
 public:
  explicit JoinedSets(std::size_t count) : up_(count) { std::iota(up_.begin(), up_.end(), 0u); }

  /// The number that stands for that one's set.
  std::uint32_t top(std::uint32_t i) {
    assert(i < up_.size());
    while (up_[i] != i) i = up_[i] = up_[up_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = top(a), b = top(b);
    up_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> up_;
};

}  // namespace frond
