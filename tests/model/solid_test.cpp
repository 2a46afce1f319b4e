#include "model/solid.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frond {
namespace {

Solid triangle() {
  Solid solid;
  solid.surface.position = {Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  solid.surface.triangle = {{0, 1, 2}};
  set_normals(solid.surface);
  return solid;
}

TEST(Solids, AreMergedWhereTheyStand) {
  Solids solids;
  std::uint16_t shape = solids.add_shape(triangle());
  solids.place(shape);
  Quat quarter = glm::angleAxis(static_cast<float>(kPi / 2), Vec3(0, 1, 0));
  solids.place(shape, Vec3(5, 0, 0), quarter, Vec3(2, 3, 1));
  EXPECT_EQ(solids.find_fault(), "");
  Surface all = merged(solids);
  EXPECT_EQ(all.find_fault(), "");
  ASSERT_EQ(all.position.size(), 6u);
  EXPECT_EQ(all.triangle[1], (std::array<std::uint32_t, 3>{3, 4, 5}));
  EXPECT_LT(glm::distance(all.position[4], Vec3(5, 0, -2)), 1e-5f);  // x turns to -z
  EXPECT_LT(glm::distance(all.position[5], Vec3(5, 3, 0)), 1e-5f);
  EXPECT_LT(glm::distance(all.normal[4], Vec3(1, 0, 0)), 1e-5f);
}

TEST(Solids, NamesWhatIsWrong) {
  Solids solids;
  solids.place(solids.add_shape(triangle()));
  Solids wrong = solids;
  wrong.shape[0] = 1;
  EXPECT_EQ(wrong.find_fault(), "solid 0 has no shape");
  wrong = solids;
  wrong.scale[0].y = 0;
  EXPECT_EQ(wrong.find_fault(), "solid 0 has no size");
  wrong = solids;
  wrong.position[0].x = INFINITY;
  EXPECT_EQ(wrong.find_fault(), "solid 0 is not at a finite place");
  wrong = solids;
  wrong.turn[0] *= 2.0f;
  EXPECT_EQ(wrong.find_fault(), "the turn of solid 0 is not of length 1");
  wrong = solids;
  wrong.turn.clear();
  EXPECT_EQ(wrong.find_fault(), "the arrays of the solids differ in length");
}

TEST(Solids, ANormalOrATurnThatIsNoNumberIsAFault) {
  Solids solids, wrong;
  solids.place(solids.add_shape(triangle()));
  wrong = solids;
  wrong.shapes[0].surface.normal[1].y = std::nanf("");
  EXPECT_EQ(wrong.find_fault(), "solid: normal 1 is not of length 1");
  wrong = solids;
  wrong.turn[0].w = std::nanf("");
  EXPECT_EQ(wrong.find_fault(), "the turn of solid 0 is not of length 1");
}

}  // namespace
}  // namespace frond
