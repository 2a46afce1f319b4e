#include "land/ground.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frond {
namespace {

TEST(Ground, MeshLiesOnTheHeights) {
  Ground ground{Seed{2}, 0.2, 2.5};
  Surface s = ground_surface(ground, Vec2(0), 20, 40);
  EXPECT_EQ(s.check(), "");
  for (const Vec3& p : s.position) {
    if (std::hypot(p.x, p.z) < 10) {
      EXPECT_NEAR(p.y, ground_height(ground, p.x, p.z), 1e-4);
    }
    EXPECT_LE(std::abs(p.y), 0.5);
  }
  for (const Vec3& n : s.normal) EXPECT_GT(n.y, 0.5f);
}

}  // namespace
}  // namespace frond
