#include "masonry/wall.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/crease.h"
#include "masonry/column.h"
#include "solids.h"

namespace frond {
namespace {

WallShape with_window() {
  WallShape shape;
  shape.width = 3.2;
  shape.height = 2.4;
  shape.openings = {{WallHole::window, 0.5, 0.8, 1.0, 1.1}, {WallHole::door, -0.9, 0, 0.8, 1.9}};
  return shape;
}

TEST(Wall, HasAClosedHullOfTheRightVolume) {
  WallShape plain;
  plain.coping = false;
  Wall wall = build_wall(plain, Seed{1});
  EXPECT_EQ(wall.hull.find_fault(), "");
  EXPECT_TRUE(closed(wall.hull));
  double courses = std::round(plain.height / 0.075);
  EXPECT_NEAR(volume(wall.hull), plain.width * courses * 0.075 * plain.thickness, 1e-3);
  Wall pierced = build_wall(with_window(), Seed{1});
  EXPECT_TRUE(closed(pierced.hull));
  EXPECT_TRUE(closed(pierced.mortar));
  EXPECT_GT(volume(pierced.mortar), 0);
  // The holes go through: a fifth of the face is missing.
  EXPECT_LT(volume(pierced.mortar), 0.82 * 3.2 * 2.5 * 0.24);
}

TEST(Wall, BricksAreInBondAndKeepOutOfTheOpenings) {
  WallShape shape = with_window();
  shape.wear = 0;
  Wall wall = build_wall(shape, Seed{1});
  std::size_t bricks = 0, panes = 0;
  double area = 0;
  for (const WallBlock& b : wall.blocks) {
    panes += b.part == WallPart::pane;
    if (b.part != WallPart::brick) continue;
    ++bricks;
    EXPECT_LE(b.size.x, 1.3f * shape.brick.x);
    bool in_window =
        std::abs(b.middle.x - 0.5f) + b.size.x / 2 < 0.49 && b.middle.y > 0.9 && b.middle.y < 1.8;
    EXPECT_FALSE(in_window);
    if (b.middle.z > 0 && b.size.x > b.size.z) area += b.size.x * b.size.y;
  }
  EXPECT_GT(bricks, 500u);
  EXPECT_EQ(panes, 2u);
  double face = 3.2 * 2.4 - 1.0 * 1.1 - 0.8 * 1.9;
  EXPECT_GT(area, 0.70 * face) << "joints and stones are the rest";
  EXPECT_LT(area, 0.95 * face);
  // No joint stands over a joint: neighbours of the course above end elsewhere.
  for (const WallBlock& a : wall.blocks)
    for (const WallBlock& b : wall.blocks) {
      if (a.part != WallPart::brick || b.part != WallPart::brick || a.size.z != b.size.z) continue;
      if (std::abs(b.middle.y - a.middle.y - 0.075f) > 1e-3 || std::abs(a.size.x - 0.23f) > 1e-3) continue;
      if (std::abs(b.size.x - 0.23f) > 1e-3) continue;
      EXPECT_GT(std::abs(a.middle.x - b.middle.x), 0.05f);
    }
}

TEST(Wall, FallsDownFromAbove) {
  WallShape shape = with_window();
  shape.coping = false;
  double whole = volume(build_wall(shape, Seed{4}).hull);
  shape.ruin = 0.6;
  Wall ruin = build_wall(shape, Seed{4});
  EXPECT_TRUE(closed(ruin.hull));
  EXPECT_LT(volume(ruin.hull), 0.9 * whole);
  EXPECT_GT(volume(ruin.hull), 0.3 * whole);
  // Each brick lies on another one or on the ground.
  for (const WallBlock& b : ruin.blocks) {
    if (b.part != WallPart::brick || b.middle.y < 0.08f) continue;
    bool held = false;
    for (const WallBlock& below : ruin.blocks)
      held = held || (std::abs(below.middle.x - b.middle.x) < (below.size.x + b.size.x) / 2 &&
                      below.middle.y < b.middle.y && below.middle.y + below.size.y / 2 > b.middle.y - 0.06f);
    EXPECT_TRUE(held) << b.middle.x << " " << b.middle.y;
  }
  EXPECT_NE(build_wall(shape, Seed{5}).blocks.size(), ruin.blocks.size());
}

TEST(Wall, TakesOpeningsThatDoNotFit) {
  WallShape shape;
  shape.openings = {
      {WallHole::window, 9, 0, 1, 1}, {WallHole::door, 0, 0, 40, 40}, {WallHole::gap, -1.9, 2.4, 0.5, 3}};
  Wall wall = build_wall(shape, Seed{1});
  EXPECT_EQ(wall.hull.find_fault(), "");
  shape.width = 0.1, shape.height = 0.05, shape.thickness = 0.05;
  EXPECT_EQ(build_wall(shape, Seed{1}).mortar.find_fault(), "");
}

TEST(Wall, CopingLiesOnTheWallAndSpansNoGap) {
  WallShape shape;
  shape.openings = {{WallHole::gap, 0.5, 0, 1.0, shape.height}};
  double top = std::round(shape.height / 0.075) * 0.075;
  std::size_t coping = 0;
  for (const WallBlock& b : build_wall(shape, Seed{1}).blocks) {
    if (b.middle.y < top) continue;
    ++coping;
    EXPECT_GE(std::abs(b.middle.x - 0.5f), 0.5f);
  }
  EXPECT_GT(coping, 30u);
}

TEST(WornBlock, IsClosedAndFillsItsBox) {
  for (double wear : {0.0, 1.0}) {
    Surface block = worn_block(Vec3(0.23f, 0.065f, 0.115f), wear, Seed{2});
    EXPECT_EQ(block.find_fault(), "");
    EXPECT_TRUE(closed(block));
    EXPECT_GT(volume(block), wear > 0 ? 0.85 : 0.95);
    EXPECT_LT(volume(block), 1.05);
  }
}

TEST(Column, IsClosedAndTapers) {
  ColumnShape shape;
  Surface column = column_surface(shape);
  EXPECT_EQ(column.find_fault(), "");
  EXPECT_TRUE(closed(column));
  float top = 0;
  for (const Vec3& p : column.position) top = std::max(top, p.y);
  EXPECT_NEAR(top, 3, 1e-4);
  auto widest = [&](float low, float high) {
    float most = 0;
    for (const Vec3& p : column.position)
      if (p.y > low && p.y < high) most = std::max(most, std::hypot(p.x, p.z));
    return most;
  };
  EXPECT_NEAR(widest(0.5f, 0.6f), 0.21, 0.01);
  EXPECT_NEAR(widest(2.5f, 2.6f), 0.21 * 0.84, 0.012);
  // Flutes: the shaft is cut in and out twenty times.
  ColumnShape plain = shape;
  plain.flutes = 0;
  EXPECT_LT(volume(column), 0.97 * volume(column_surface(plain)));
  shape.broken = 0.5;
  EXPECT_LT(volume(column_surface(shape)), 0.7 * volume(column));
  EXPECT_TRUE(closed(column_surface(shape)));
}

TEST(Creased, PartsSharpEdgesOnly) {
  WallShape shape;
  shape.coping = false;
  shape.width = shape.height = 0.5;
  Surface hull = build_wall(shape, Seed{1}).hull, sharp = creased(hull, 0.6);
  EXPECT_EQ(sharp.find_fault(), "");
  EXPECT_EQ(sharp.triangle.size(), hull.triangle.size());
  for (const Vec3& n : sharp.normal)
    EXPECT_NEAR(std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}), 1, 1e-4);
  EXPECT_EQ(creased(hull, kPi).position.size(), hull.position.size());
}

}  // namespace
}  // namespace frond
