#include "foliage/sprig.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

TEST(Sprig, EachKindIsAMeshOfUnitLength) {
  for (SprigKind kind :
       {SprigKind::oval, SprigKind::lobed, SprigKind::narrow, SprigKind::needles, SprigKind::feather}) {
    SprigShape shape;
    shape.kind = kind;
    shape.leaves = 9;
    Surface s = sprig_surface(shape);
    EXPECT_EQ(s.find_fault(), "");
    EXPECT_EQ(s.uv.size(), s.position.size());
    Vec3 low = s.position[0], high = low;
    for (const Vec3& p : s.position) low = glm::min(low, p), high = glm::max(high, p);
    EXPECT_GT(low.y, -0.15f);
    EXPECT_GT(high.y, 0.75f);
    EXPECT_LT(high.y, 1.35f);
    for (const Vec2& uv : s.uv) {
      EXPECT_GE(uv.y, -1e-5f);
      EXPECT_LE(uv.y, 1.00001f);
    }
  }
}

TEST(Sprig, HasAsManyLeavesAsAsked) {
  SprigShape shape;
  shape.leaves = 4;
  std::size_t four = sprig_surface(shape).triangle.size();
  shape.leaves = 8;
  EXPECT_EQ(sprig_surface(shape).triangle.size(), 2 * four);
}

TEST(Sprig, UpperSidesLookUpUnlessLeavesHang) {
  auto facing = [](double hang) {
    SprigShape shape;
    shape.hang = hang;
    Surface s = sprig_surface(shape);
    double up = 0;
    for (const Vec3& n : s.normal) up += n.z;
    return up / static_cast<double>(s.normal.size());
  };
  EXPECT_GT(facing(0), 0.4);
  EXPECT_LT(facing(1), facing(0) - 0.2);
}

}  // namespace
}  // namespace frond
