#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace frond {

/// Places in cells of one size, to find those that are near; hashed, so that there is no border.
class RimGrid {
 public:
  explicit RimGrid(float cell) : cell_(cell), head_(kSlots, kEmpty) {}

  void add(Vec3 at, std::uint32_t who) {
    std::uint32_t& head = head_[slot(cell_of(at.x), cell_of(at.y), cell_of(at.z))];
    entry_.push_back({head, who});
    head = static_cast<std::uint32_t>(entry_.size() - 1);
  }

  /// Calls `found(who)` for all that may be nearer than a cell's size, and others.
  template <class Found>
  void each(Vec3 at, const Found& found) const {
    int i = cell_of(at.x), j = cell_of(at.y), k = cell_of(at.z);
    for (int x = i - 1; x <= i + 1; ++x)
      for (int y = j - 1; y <= j + 1; ++y)
        for (int z = k - 1; z <= k + 1; ++z)
          for (std::uint32_t e = head_[slot(x, y, z)]; e != kEmpty; e = entry_[e].next) found(entry_[e].who);
  }

 private:
  static constexpr std::uint32_t kEmpty = ~0u, kSlots = 1u << 15;
  struct Entry {
    std::uint32_t next, who;
  };
  int cell_of(float x) const { return static_cast<int>(std::floor(x / cell_)); }
  static std::size_t slot(int x, int y, int z) {
    std::uint32_t h = static_cast<std::uint32_t>(x) * 73856093u ^ static_cast<std::uint32_t>(y) * 19349663u ^
                      static_cast<std::uint32_t>(z) * 83492791u;
    return (h ^ h >> 15) % kSlots;
  }
  float cell_;
  std::vector<std::uint32_t> head_;
  std::vector<Entry> entry_;
};

}  // namespace frond
