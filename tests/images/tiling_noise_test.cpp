#include "images/tiling_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frond {
namespace {

TEST(TilingNoise, RepeatsAndIsSmooth) {
  double low = 1, high = -1;
  for (int i = 0; i < 2000; ++i) {
    double x = Seed{1}.child("x", i).range(-9, 9), y = Seed{1}.child("y", i).range(-9, 9);
    double value = tiling_noise(x, y, 5, 3, Seed{7});
    EXPECT_NEAR(value, tiling_noise(x + 5, y - 6, 5, 3, Seed{7}), 1e-9);
    EXPECT_LT(std::abs(value - tiling_noise(x + 1e-3, y, 5, 3, Seed{7})), 0.01);
    low = std::min(low, value), high = std::max(high, value);
  }
  EXPECT_LT(low, -0.5);
  EXPECT_GT(high, 0.5);
  EXPECT_GE(low, -1.1);
  EXPECT_LE(high, 1.1);
}

TEST(TilingCells, RepeatAndAreInOrder) {
  for (int i = 0; i < 500; ++i) {
    double x = Seed{2}.child("x", i).range(0, 6), y = Seed{2}.child("y", i).range(0, 4);
    Cells a = tiling_cells(x, y, 6, 4, Seed{3}), b = tiling_cells(x + 12, y + 4, 6, 4, Seed{3});
    EXPECT_LE(a.nearest, a.second);
    EXPECT_NEAR(a.nearest, b.nearest, 1e-9);
    EXPECT_EQ(a.own, b.own);
  }
}

}  // namespace
}  // namespace frond
