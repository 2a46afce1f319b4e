#include "foliage/foliage_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frond {
namespace {

struct Box {
  Vec3 low{1e9f}, high{-1e9f};
};

Box box_of(const Surface& s) {
  Box box;
  for (Vec3 p : s.position) box.low = glm::min(box.low, p), box.high = glm::max(box.high, p);
  return box;
}

double upward(const Surface& s) {  // share of the area whose front looks up
  double up = 0, all = 0;
  for (auto [a, b, c] : s.triangle) {
    Vec3 area = glm::cross(s.position[b] - s.position[a], s.position[c] - s.position[a]);
    all += glm::length(area), up += area.z > 0 ? glm::length(area) : 0;
  }
  return up / all;
}

TEST(FoliageShapes, FrondHasItsMeasures) {
  FrondShape shape;
  shape.bend = 0, shape.droop = 0;
  TwigParts flat = frond_foliage(shape, Seed{1});
  EXPECT_EQ(flat.blades.find_fault(), "");
  EXPECT_EQ(flat.stem.find_fault(), "");
  EXPECT_EQ(flat.blades.uv.size(), flat.blades.position.size());
  Box box = box_of(flat.blades);
  EXPECT_NEAR(box.high.x - box.low.x, shape.width, 0.15);
  EXPECT_NEAR(box.high.y, 1.0, 0.12);
  EXPECT_GT(box.low.y, 0.5 * shape.stalk);
  EXPECT_GT(box.high.z, 0.02);  // the V
  EXPECT_GT(upward(flat.blades), 0.85);
  shape.pairs = 20;
  EXPECT_LT(frond_foliage(shape, Seed{1}).blades.triangle.size(), flat.blades.triangle.size() * 6 / 10);
}

TEST(FoliageShapes, FrondBendsDownAndDroops) {
  FrondShape shape;
  shape.bend = radians(120.0);
  TwigParts bent = frond_foliage(shape, Seed{1});
  EXPECT_LT(box_of(bent.stem).low.z, -0.25f);
  EXPECT_LT(box_of(bent.blades).low.z, box_of(bent.stem).low.z);
}

TEST(FoliageShapes, FernHasLobedLeafletsAndEndsInAPoint) {
  FrondShape shape{.pairs = 20, .bend = 0, .droop = 0, .lobes = 8};
  TwigParts fern = frond_foliage(shape, Seed{1});
  EXPECT_EQ(fern.blades.find_fault(), "");
  EXPECT_GE(fern.blades.triangle.size(), 2u * 20 * 8 * 4);
  EXPECT_LT(fern.blades.triangle.size(), 2u * 20 * 8 * 4 + 20);
  EXPECT_GT(upward(fern.blades), 0.85);
  float middle = 0, tip = 0;
  for (Vec3 p : fern.blades.position) {
    if (p.y > 0.35f && p.y < 0.5f) middle = std::max(middle, std::abs(p.x));
    if (p.y > 0.92f) tip = std::max(tip, std::abs(p.x));
  }
  EXPECT_NEAR(2 * middle, shape.width, 0.15);
  EXPECT_LT(tip, 0.55f * middle);
}

TEST(FoliageShapes, LeavesOfLessDetailHaveTheSameOutline) {
  BladeShape shape;
  Box fine = box_of(blade_surface(shape));
  std::size_t triangles[4] = {};
  for (int detail : {1, 2, 3}) {
    shape.detail = detail;
    Surface blade = blade_surface(shape);
    EXPECT_EQ(blade.find_fault(), "");
    triangles[detail] = blade.triangle.size();
    Box box = box_of(blade);
    EXPECT_NEAR(box.high.y, fine.high.y, 1e-5);
    EXPECT_NEAR(box.high.x, fine.high.x, 0.1 * shape.width);
  }
  EXPECT_EQ(triangles[1], 10u);
  EXPECT_EQ(triangles[2], 52u);
  EXPECT_EQ(triangles[3], 126u);
}

TEST(FoliageShapes, SprigHasItsLeaves) {
  TwigShape shape;
  TwigParts sprig = sprig_foliage(shape, Seed{2});
  EXPECT_EQ(sprig.blades.find_fault(), "");
  EXPECT_EQ(sprig.stem.find_fault(), "");
  EXPECT_EQ(sprig.blades.triangle.size(), blade_surface(shape.leaf).triangle.size() * 9);
  EXPECT_NEAR(box_of(sprig.blades).high.y, 1.0, 0.2);
  EXPECT_GT(upward(sprig.blades), 0.8);
}

TEST(FoliageShapes, DifferBySeedAlone) {
  EXPECT_EQ(frond_foliage({}, Seed{1}).blades.position, frond_foliage({}, Seed{1}).blades.position);
  EXPECT_NE(frond_foliage({}, Seed{1}).blades.position, frond_foliage({}, Seed{2}).blades.position);
  EXPECT_NE(sprig_foliage({}, Seed{1}).blades.position, sprig_foliage({}, Seed{2}).blades.position);
}

}  // namespace
}  // namespace frond
