#include "emit/crumbling.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

using Triangles = std::vector<std::array<Vec3, 3>>;

/// A square, one unit wide, in a plane that lies anyhow.
Triangles square(Vec3 at, Vec3 along, Vec3 across) {
  return {{at, at + along, at + across}, {at + along, at + along + across, at + across}};
}

TEST(ApartArea, OfAFlatLeafIsItsArea) {
  EXPECT_NEAR(apart_area(square(Vec3(0), Vec3(0.6f, 0.8f, 0), Vec3(0, 0, 1))), 1, 0.1);
}

TEST(ApartArea, CountsLeavesThatLieOnOneAnotherOnce) {
  Triangles leaves;
  for (int i = 0; i < 5; ++i)
    for (const auto& t : square(Vec3(0, 0.001f * static_cast<float>(i), 0), Vec3(1, 0, 0), Vec3(0, 0, 1)))
      leaves.push_back(t);
  EXPECT_NEAR(apart_area(leaves), 1, 0.1);
}

TEST(ApartArea, OfABodyIsHalfItsSkin) {
  // Cauchy's formula: the mean shadow of a convex body is a quarter of its skin.
  Triangles cube;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 a(0), b(0), c(0);
    a[axis] = b[(axis + 1) % 3] = c[(axis + 2) % 3] = 1;
    for (Vec3 at : {Vec3(0), a})
      for (const auto& t : square(at, b, c)) cube.push_back(t);
  }
  EXPECT_NEAR(apart_area(cube), 3, 0.15);
}

}  // namespace
}  // namespace frond
