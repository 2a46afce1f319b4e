#include "field/solid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "closed.h"

namespace frond {
namespace {

constexpr float kVoxel = 0.02f;

/// A hollow ball.
Filling fill_shell(Cell first, std::span<float, kBlockVoxels> distance) {
  std::size_t n = 0;
  for (int i = 0; i < kBlockSide; ++i)
    for (int j = 0; j < kBlockSide; ++j)
      for (int k = 0; k < kBlockSide; ++k) {
        float far = glm::length(voxel_middle({first.i + i, first.j + j, first.k + k}, kVoxel));
        distance[n++] = std::max(far - 0.5f, 0.3f - far);
      }
  return Filling::crossed;
}

TEST(SolidSurface, LiesOnTheZeroOfTheDistances) {
  Surface shell = *solid_surface({DVec3(-0.55), DVec3(0.55)}, kVoxel, fill_shell);
  EXPECT_EQ(shell.find_fault(), "");
  Body body = body_of(shell);
  EXPECT_EQ(body.loose, 0u);
  EXPECT_EQ(body.euler, 4);  // two balls
  EXPECT_NEAR(body.volume, 4 * kPi / 3 * (0.125 - 0.027), 0.005);
  for (std::size_t v = 0; v < shell.position.size(); ++v) {
    float far = glm::length(shell.position[v]);
    EXPECT_LT(std::min(std::abs(far - 0.5f), std::abs(far - 0.3f)), kVoxel * kVoxel / (2 * 0.3f));
    EXPECT_GT(glm::dot(shell.normal[v], shell.position[v] / far) * (far > 0.4f ? 1 : -1), 0.99f);
  }
}

TEST(SolidSurface, TakesInnerBlocksAsAWhole) {
  auto fill = [](Cell first, std::span<float, kBlockVoxels> distance) {
    Cell middle{first.i + 4, first.j + 4, first.k + 4};
    if (glm::length(voxel_middle(middle, kVoxel)) < 0.2f) return Filling::inside;
    if (glm::length(voxel_middle(middle, kVoxel)) > 0.8f) return Filling::outside;
    Filling crossed = fill_shell(first, distance);
    for (std::size_t n = 0; n < distance.size(); ++n) {
      auto at = static_cast<int>(n);
      float far =
          glm::length(voxel_middle({first.i + at / 64, first.j + at / 8 % 8, first.k + at % 8}, kVoxel));
      distance[n] = far - 0.5f;
    }
    return crossed;
  };
  Body body = body_of(*solid_surface({DVec3(-0.55), DVec3(0.55)}, kVoxel, fill));
  EXPECT_EQ(body.loose, 0u);
  EXPECT_EQ(body.euler, 2);
  EXPECT_NEAR(body.volume, 4 * kPi / 3 * 0.125, 0.005);
}

TEST(SolidSurface, OfNothingIsEmpty) {
  auto none = [](Cell, std::span<float, kBlockVoxels>) { return Filling::outside; };
  EXPECT_TRUE(solid_surface({DVec3(-1), DVec3(1)}, kVoxel, none)->triangle.empty());
}

}  // namespace
}  // namespace frond
