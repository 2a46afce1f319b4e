#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/vec.h"

namespace frond {

/// Points and boxes in cubic cells of one size, found by hash, for finding neighbours; the space has no
/// border; beyond 2^30 cells from the middle all lies in the outermost one, and so does what is no number.
class CellGrid {
 public:
  explicit CellGrid(float cell) : cell_(cell), head_(kFewestSlots, kEmpty) {}

  void add(Vec3 at, std::uint32_t who) { put(cell_of(at), who); }
  /// Adds an object by its bounding box.
  void add(Vec3 low, Vec3 high, std::uint32_t who) {
    each_cell(low, high, [&](glm::ivec3 cell) { put(cell, who); });
  }

  std::size_t size() const { return entry_.size(); }
  /// Removes everything added since it had that size.
  void shrink(std::size_t size) {
    for (; entry_.size() > size; entry_.pop_back()) head_[slot(entry_.back().cell)] = entry_.back().next;
  }

  /// Calls `found(who)` for everything that may be nearer than a cell's size, and for some others: cell by
  /// cell, x first, and in each what was added last first.
  template <class Found>
  void each(Vec3 at, const Found& found) const {
    each(at - cell_, at + cell_, found);
  }
  /// Calls `found(who)` for everything that may reach into a box, and for some others; what lies in several
  /// of its cells comes more than once.
  template <class Found>
  void each(Vec3 low, Vec3 high, const Found& found) const {
    each_cell(low, high, [&](glm::ivec3 cell) {
      for (std::uint32_t e = head_[slot(cell)]; e != kEmpty; e = entry_[e].next)
        if (entry_[e].cell == cell) found(entry_[e].who);
    });
  }

 private:
  static constexpr std::uint32_t kEmpty = ~0u;
  static constexpr std::size_t kFewestSlots = std::size_t{1} << 17, kMostSlots = std::size_t{1} << 26;
  struct Entry {
    std::uint32_t next, who;
    glm::ivec3 cell;
  };
  void put(glm::ivec3 cell, std::uint32_t who) {
    if (entry_.size() >= head_.size() && head_.size() < kMostSlots) widen();
    std::uint32_t& head = head_[slot(cell)];
    entry_.push_back({head, who, cell});
    head = static_cast<std::uint32_t>(entry_.size() - 1);
  }
  /// More slots, so that few cells share one; what is found, and its order, stays.
  void widen() {
    head_.assign(4 * head_.size(), kEmpty);
    for (std::uint32_t e = 0; e < entry_.size(); ++e) {
      std::uint32_t& head = head_[slot(entry_[e].cell)];
      entry_[e].next = std::exchange(head, e);
    }
  }
  template <class Visit>
  void each_cell(Vec3 low, Vec3 high, const Visit& visit) const {
    glm::ivec3 from = cell_of(low), to = cell_of(high);
    for (int x = from.x; x <= to.x; ++x)
      for (int y = from.y; y <= to.y; ++y)
        for (int z = from.z; z <= to.z; ++z) visit(glm::ivec3(x, y, z));
  }
  glm::ivec3 cell_of(Vec3 at) const {
    constexpr float kOutermost = 1 << 30;
    auto one = [](float cell) {
      if (!(cell > -kOutermost)) return static_cast<int>(-kOutermost);
      return cell < kOutermost ? static_cast<int>(cell) : static_cast<int>(kOutermost);
    };
    Vec3 cell = glm::floor(at / cell_);
    return {one(cell.x), one(cell.y), one(cell.z)};
  }
  std::size_t slot(glm::ivec3 cell) const {
    glm::uvec3 c(cell);
    std::uint32_t h = c.x * 73856093u ^ c.y * 19349663u ^ c.z * 83492791u;
    return (h ^ h >> 15) & (head_.size() - 1);
  }

  float cell_;
  std::vector<std::uint32_t> head_;
  std::vector<Entry> entry_;
};

/// Throws darts: takes places, no two of which are nearer to each other than `apart`.
class Darts {
 public:
  explicit Darts(float apart) : apart_(apart), grid_(apart) {}

  /// Whether a place is free; then it is taken.
  bool try_add(Vec3 at) {
    bool free = true;
    grid_.each(at, [&](std::uint32_t who) { free = free && glm::distance(taken_[who], at) >= apart_; });
    if (!free) return false;
    grid_.add(at, static_cast<std::uint32_t>(taken_.size()));
    taken_.push_back(at);
    return true;
  }

 private:
  float apart_;
  CellGrid grid_;
  std::vector<Vec3> taken_;
};

}  // namespace frond
