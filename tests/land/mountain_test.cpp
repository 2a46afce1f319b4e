#include "land/mountain.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace frond {
namespace {

TEST(Mountain, StandsWhereItIsAskedFor) {
  MountainShape shape{.height = 800, .distance = 6000, .width = 3000, .toward = 90};
  Surface s = mountain_surface(shape, glm::normalize(Vec3(0, 1, 1)));
  EXPECT_EQ(s.find_fault(), "");
  ASSERT_EQ(s.uv.size(), s.position.size());
  float top = 0;
  for (std::size_t i = 0; i < s.position.size(); ++i) {
    top = std::max(top, s.position[i].y);
    EXPECT_GT(s.position[i].x, 3000);
    EXPECT_LE(std::abs(s.position[i].z), 1501);
  }
  EXPECT_NEAR(top, 800, 60);
  for (auto [a, b, c] : s.triangle)
    EXPECT_GT(glm::cross(s.position[b] - s.position[a], s.position[c] - s.position[a]).y, 0);
}

TEST(Mountain, LightAndSnowFallAsAsked) {
  MountainShape shape{.snow = 300};
  Vec3 sun = glm::normalize(Vec3(1, 0.5f, 0));
  Surface s = mountain_surface(shape, sun);
  double lit = 0, away = 0;
  int with = 0, without = 0;
  for (std::size_t i = 0; i < s.position.size(); ++i) {
    EXPECT_GE(s.uv[i].x, 0);
    EXPECT_LE(s.uv[i].x, 1);
    if (s.uv[i].y == 1) {
      EXPECT_GT(s.position[i].y, 150);
    }
    float facing = glm::dot(s.normal[i], sun);
    if (facing > 0.7f) lit += s.uv[i].x, ++with;
    if (facing < 0.1f) away += s.uv[i].x, ++without;
  }
  ASSERT_GT(with, 100);
  ASSERT_GT(without, 100);
  EXPECT_GT(lit / with, 2 * away / without);
  EXPECT_TRUE(std::ranges::any_of(s.uv, [](Vec2 uv) { return uv.y == 1; }));
  EXPECT_FALSE(std::ranges::any_of(mountain_surface({}, sun).uv, [](Vec2 uv) { return uv.y == 1; }));
}

}  // namespace
}  // namespace frond
