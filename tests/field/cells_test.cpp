#include "field/cells.h"

#include <gtest/gtest.h>

#include "core/seed.h"

namespace frond {
namespace {

std::size_t count(const CellSet& cells) {
  std::size_t sum = 0;
  cells.visit([&](Cell cell) { sum += cells.holds(cell); });
  return sum;
}

TEST(Cells, that_touch_along_an_edge_or_at_a_corner_are_joined) {
  for (Cell other : {Cell{8, 8, 7}, Cell{8, 8, 8}, Cell{7, 8, 6}}) {
    CellSet cells;
    cells.add({7, 7, 7}), cells.add(other);
    mend_contacts(cells);
    int apart = std::abs(other.i - 7) + std::abs(other.j - 7) + std::abs(other.k - 7);
    EXPECT_EQ(count(cells), static_cast<std::size_t>(apart) + 1);  // the way from face to face
  }
}

TEST(Cells, that_share_a_face_or_lie_apart_stay_as_they_are) {
  CellSet cells;
  cells.add({0, 0, 0}), cells.add({1, 0, 0}), cells.add({-2, 0, 0});
  mend_contacts(cells);
  EXPECT_EQ(count(cells), 3u);
}

TEST(Cells, at_random_have_every_edge_between_two_faces) {
  CellSet cells;
  for (std::uint64_t i = 0; i < 700; ++i) {
    Seed seed = Seed{3}.child(i);
    auto at = [&](std::uint64_t axis) { return static_cast<std::int32_t>(seed.child(axis).range(-10, 10)); };
    cells.add({at(0), at(1), at(2)});
  }
  mend_contacts(cells);
  // Round each edge of the grid four cells lie; two that face each other across it must not be alone.
  for (std::int32_t i = -13; i < 13; ++i)
    for (std::int32_t j = -13; j < 13; ++j)
      for (std::int32_t k = -13; k < 13; ++k)
        for (int axis = 0; axis < 3; ++axis) {
          auto is = [&](int a, int b) {
            return cells.holds(axis == 0   ? Cell{i, j + a, k + b}
                               : axis == 1 ? Cell{i + a, j, k + b}
                                           : Cell{i + a, j + b, k});
          };
          EXPECT_FALSE(is(0, 0) == is(1, 1) && is(0, 1) == is(1, 0) && is(0, 0) != is(0, 1));
        }
}

}  // namespace
}  // namespace frond
