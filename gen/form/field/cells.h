#pragma once

#include <array>
#include <cstdint>
#include <map>

#include "field/blocks.h"

namespace frond {

/// A set of grid cells. Not thread-safe.
class CellSet {
 public:
  void add(Cell cell);
  bool holds(Cell cell) const;

  /// Calls visit(cell) for each, block by block.
  template <class Visit>
  void visit(const Visit& visit) const;

 private:
  /// Which voxels of a block are in the set.
  using Mask = std::array<std::uint64_t, kBlockVoxels / 64>;

  const Mask* block(std::uint64_t key) const;

  std::map<std::uint64_t, Mask> blocks_;
  mutable std::uint64_t last_key_ = UINT64_MAX;  // consecutive queries are mostly near each other
  mutable const Mask* last_ = nullptr;
};

/// Adds cells where some touch only at an edge or corner, until none do and the surface of all is a manifold:
/// every edge between two faces (well-composed, Latecki 1997).
void mend_contacts(CellSet& cells);

template <class Visit>
void CellSet::visit(const Visit& visit) const {
  for (const auto& [key, mask] : blocks_) {
    Cell first = block_origin(key);
    for (std::int32_t i = 0; i < kBlockVoxels; ++i)
      if (mask[static_cast<std::size_t>(i) >> 6] >> (i & 63) & 1)
        visit(Cell{first.i + (i >> 6), first.j + (i >> 3 & 7), first.k + (i & 7)});
  }
}

}  // namespace frond
