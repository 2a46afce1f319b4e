#include "geometry/relief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/tubes.h"
#include "shapes.h"

namespace frond {
namespace {

Surface cut_trunk(double depth, float upto) {
  TubeShape shape{.wrap = 0.3, .side = 0.05};
  Relief relief{
      .depth = depth,
      .facet = 0.01,
      .height = [](Vec2 uv) { return 0.5f + 0.5f * std::cos(static_cast<float>(2 * kPi) * 2 * uv.x); },
      .share = [&](Vec3 at, Vec3) { return std::clamp(2 * (upto - at.y), 0.0f, 1.0f); }};
  return raised(tube_surface(trunk(20, 2, 0.1f), shape), relief);
}

TEST(Relief, IsLetInToItsDepthAndNoDeeper) {
  Surface s = cut_trunk(0.02, 1);
  EXPECT_EQ(s.find_fault(), "");
  ASSERT_EQ(s.uv.size(), s.position.size());
  float least = 1;
  for (std::size_t i = 0; i < s.position.size(); ++i) {
    if (s.position[i].y > 1.9f) continue;
    float away = std::hypot(s.position[i].x, s.position[i].z);
    EXPECT_LT(away, 0.102f);
    EXPECT_GT(away, 0.078f);
    if (s.position[i].y > 1.05f) {
      EXPECT_GT(away, 0.0965f);
    }
    least = std::min(least, away);
  }
  EXPECT_LT(least, 0.083f);
}

TEST(Relief, LeavesAloneWhatIsFar) {
  Surface whole = tube_surface(trunk(20, 2, 0.1f), {.wrap = 0.3, .side = 0.05}), same = cut_trunk(0.02, -1);
  EXPECT_EQ(same.position, whole.position);
  EXPECT_EQ(same.triangle, whole.triangle);
}

TEST(Relief, NormalsLeanAsTheFurrowsDo) {
  int leaning = 0;
  for (const Surface s = cut_trunk(0.02, 1); auto [a, b, c] : s.triangle) {
    if (s.position[a].y > 0.4f) continue;
    Vec3 flat = glm::cross(s.position[b] - s.position[a], s.position[c] - s.position[a]);
    if (glm::length(flat) < 1e-9f) continue;
    EXPECT_GT(glm::dot(glm::normalize(flat), glm::normalize(s.normal[a] + s.normal[b] + s.normal[c])), 0.7f);
    Vec3 out(s.position[a].x, 0, s.position[a].z);
    leaning += glm::dot(s.normal[a], glm::normalize(out)) < 0.97f;
  }
  EXPECT_GT(leaning, 100);
}

}  // namespace
}  // namespace frond
