#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace frond {

/// Points in hashed cells of one size, for finding neighbours; the space has no border.
class RimGrid {
 public:
  explicit RimGrid(float cell) : cell_(cell), head_(kSlots, kEmpty) {}

  void add(Vec3 at, std::uint32_t who) { put(slot(cell_of(at.x), cell_of(at.y), cell_of(at.z)), who); }
  /// Adds an object by its bounding box.
  void add(Vec3 low, Vec3 high, std::uint32_t who) {
    each_slot(low, high, [&](std::size_t slot) { put(slot, who); });
  }

  std::size_t size() const { return entry_.size(); }
  /// Removes everything added since it had that size.
  void shrink(std::size_t size) {
    for (; entry_.size() > size; entry_.pop_back()) head_[entry_.back().slot] = entry_.back().next;
  }

  /// Calls `found(who)` for everything that may be nearer than a cell's size, and for some others.
  template <class Found>
  void each(Vec3 at, const Found& found) const {
    each(at - cell_, at + cell_, found);
  }
  /// The same for everything that may reach into a box; some are reported more than once.
  template <class Found>
  void each(Vec3 low, Vec3 high, const Found& found) const {
    each_slot(low, high, [&](std::size_t slot) {
      for (std::uint32_t e = head_[slot]; e != kEmpty; e = entry_[e].next) found(entry_[e].who);
    });
  }

 private:
  static constexpr std::uint32_t kEmpty = ~0u, kSlots = 1u << 17;
  struct Entry {
    std::uint32_t next, who, slot;
  };
  void put(std::size_t slot, std::uint32_t who) {
    entry_.push_back({head_[slot], who, static_cast<std::uint32_t>(slot)});
    head_[slot] = static_cast<std::uint32_t>(entry_.size() - 1);
  }
  template <class Visit>
  void each_slot(Vec3 low, Vec3 high, const Visit& visit) const {
    for (int x = cell_of(low.x), end = cell_of(high.x); x <= end; ++x)
      for (int y = cell_of(low.y), top = cell_of(high.y); y <= top; ++y)
        for (int z = cell_of(low.z), back = cell_of(high.z); z <= back; ++z) visit(slot(x, y, z));
  }
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
