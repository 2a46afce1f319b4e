#include "land/puddles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/noise.h"

namespace frond {
namespace {

template <class Height>
GroundGrid grid_with(const Height& height, int side = 41, float cell = 0.1f) {
  GroundGrid grid{Vec2(-cell * static_cast<float>(side / 2)), cell, side, {}, {}};
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column)
      grid.height.push_back(height(grid.low + cell * Vec2(column, row)));
  return grid;
}

GroundGrid bowl() {
  return grid_with([](Vec2 p) { return 0.1f * std::min(glm::dot(p, p), 1.0f); });
}

GroundGrid rough(int seed) {
  return grid_with([&](Vec2 p) { return 0.1f * static_cast<float>(fractal_noise(Vec3(p.x, seed, p.y), 3)); });
}

TEST(Puddles, AFloodFillsABowlToItsBrim) {
  GroundGrid grid = bowl();
  for (float level : priority_flood(grid).level) EXPECT_NEAR(level, 0.1f, 0.001f);
  grid.drain.resize(grid.height.size());
  grid.drain[grid.index(20, 20)] = true;
  EXPECT_EQ(priority_flood(grid).level, grid.height) << "it runs off where there is a pond";
}

TEST(Puddles, AFloodIsTheLowestFromWhichAllRunsOff) {
  for (int seed = 0; seed < 6; ++seed) {
    GroundGrid grid = rough(seed);
    std::vector<float> full = priority_flood(grid).level;
    for (int row = 1; row + 1 < grid.side; ++row)
      for (int column = 1; column + 1 < grid.side; ++column) {
        std::size_t k = grid.index(column, row);
        float lowest = 1e9f;
        for (int y : {-1, 0, 1})
          for (int x : {-1, 0, 1})
            if (x != 0 || y != 0) lowest = std::min(lowest, full[grid.index(column + x, row + y)]);
        EXPECT_EQ(full[k], std::max(grid.height[k], lowest));
      }
  }
}

TEST(Puddles, AreLevelAndGrowWithTheirDepth) {
  GroundGrid grid = bowl();
  std::size_t last = 0;
  for (double depth : {0.005, 0.02, 0.05, 0.2}) {
    Surface water = puddles(grid, priority_flood(grid).level, depth);
    EXPECT_EQ(water.find_fault(), "");
    EXPECT_GT(water.triangle.size(), last);
    last = water.triangle.size();
    for (const Vec3& p : water.position) EXPECT_NEAR(p.y, std::min(depth, 0.099), 1e-5);
    for (const auto& t : water.triangle) {
      Vec3 a = water.position[t[0]], b = water.position[t[1]], c = water.position[t[2]];
      EXPECT_GT(glm::cross(b - a, c - a).y, 0) << "seen from above";
    }
  }
}

TEST(Puddles, StandNowhereOnASlope) {
  GroundGrid slope = grid_with([](Vec2 p) { return 0.2f * p.x; });
  EXPECT_TRUE(puddles(slope, priority_flood(slope).level, 0.04).triangle.empty());
}

TEST(Puddles, FillWithWhatHasFallenUpToALimit) {
  EXPECT_EQ(puddle_depth(0), 0);
  EXPECT_GT(puddle_depth(4), puddle_depth(2));
  EXPECT_EQ(puddle_depth(50), puddle_depth(100));
}

}  // namespace
}  // namespace frond
