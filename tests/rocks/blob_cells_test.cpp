#include "rocks/blob_cells.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

/// The leaf at a place, or nothing outside.
const BlobCells::Cell* leaf_at(const BlobCells& cells, const DVec3& p) {
  DVec3 part = (p - cells.root.low) / cells.root.size();
  if (part.x < 0 || part.y < 0 || part.z < 0 || part.x >= 1 || part.y >= 1 || part.z >= 1) return nullptr;
  std::size_t i = 0;
  while (cells.cell[i].child >= 0) {
    part *= 2.0;
    DVec3 half = glm::floor(part);
    part -= half;
    i = static_cast<std::size_t>(cells.cell[i].child + static_cast<int>(half.x + 2 * half.y + 4 * half.z));
  }
  return &cells.cell[i];
}

TEST(BlobCells, NeighboursDifferByOneLevel) {
  for (std::uint64_t i = 0; i < 12; ++i) {
    BlobCells cells = cut_cells({random_blobs({}, Seed{i}), Falloff::gaussian, 1}, {6, 0.001});
    for (const BlobCells::Cell& cell : cells.cell) {
      if (cell.child >= 0) continue;
      Box box = cells.box(cell);
      for (int k = 0; k < 27; ++k) {
        DVec3 way(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
        if (glm::dot(way, way) > 2.5 || k == 13) continue;
        const BlobCells::Cell* next = leaf_at(cells, box.middle() + way * box.size() * 0.501);
        if (next) {
          EXPECT_LE(std::abs(next->level - cell.level), 1);
        }
      }
    }
  }
}

TEST(BlobCells, ClearOnesHaveOneSign) {
  for (std::uint64_t i = 0; i < 12; ++i) {
    Blobs shape{random_blobs({}, Seed{i}), Falloff::soft, 1};
    BlobCells cells = cut_cells(shape, {5, 0.0003});
    std::size_t clear = 0;
    for (std::size_t c = 0; c < cells.cell.size(); ++c) {
      const BlobCells::Cell& cell = cells.cell[c];
      if (cell.child >= 0) continue;
      Box box = cells.box(cell);
      EXPECT_EQ(field_value(shape, box.middle()) > 0, cell.inside);
      if (!cell.clear) continue;
      ++clear;
      for (std::uint64_t k = 0; k < 20; ++k) {
        Seed s = Seed{i}.child("p", c).child(k);
        DVec3 p = box.low + box.size() * DVec3(s.child(0).unit(), s.child(1).unit(), s.child(2).unit());
        EXPECT_EQ(field_value(shape, p) > 0, cell.inside);
      }
    }
    EXPECT_GT(clear, 100u);
  }
}

TEST(BlobCells, AreCoarseWhereTheSurfaceIsFlat) {
  // A disc: sharply bent at its rim only.
  Blobs shape{{{DVec3(2, 0.4, 2), DVec3(0)}}, Falloff::cubic, 0.5};
  BlobCells fine = cut_cells(shape, {8, 0}), cells = cut_cells(shape, {8, 0.001});
  EXPECT_LT(cells.cell.size(), fine.cell.size() / 8);
  EXPECT_EQ(cut_cells({{{DVec3(1), DVec3(0)}}, Falloff::gaussian, 1}, {}).cell.size(), 0u);
}

}  // namespace
}  // namespace frond
