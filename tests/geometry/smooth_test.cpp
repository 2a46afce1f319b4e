#include "geometry/smooth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shapes.h"

namespace frond {
namespace {

TEST(Smooth, KeepsTheNodesAndAddsBetween) {
  Skeleton coarse = candelabrum(6, Seed{1});
  Skeleton fine = smooth(coarse, 4);
  EXPECT_EQ(fine.find_fault(), "");
  EXPECT_EQ(fine.size(), 1 + (coarse.size() - 1) * 4);
  for (std::size_t i = 1; i < coarse.size(); ++i)
    EXPECT_EQ(fine.position[1 + (i - 1) * 4 + 3], coarse.position[i]) << i;
}

TEST(Smooth, HasNoKinksInsideABranch) {
  Skeleton coarse;
  for (int i = 0; i < 6; ++i)
    coarse.add(Vec3(0.1f * static_cast<float>(i % 2), 0.2f * static_cast<float>(i), 0), 0.1f, i - 1, 0);
  Skeleton fine = smooth(coarse, 8);
  for (std::size_t i = 2; i < fine.size(); ++i) {
    Vec3 a = glm::normalize(fine.position[i - 1] - fine.position[i - 2]);
    Vec3 b = glm::normalize(fine.position[i] - fine.position[i - 1]);
    EXPECT_GT(glm::dot(a, b), std::cos(radians(22.0f))) << i;
  }
}

}  // namespace
}  // namespace frond
