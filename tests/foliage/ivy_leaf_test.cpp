#include "foliage/ivy_leaf.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frond {
namespace {

int lobes(IvyForm form) {
  // Tips of the outline that stand out between two hollows, both sides counted.
  int count = 0;
  for (int i = -170; i <= 170; ++i) {
    double before = ivy_rim(form, radians(i - 4.0)), here = ivy_rim(form, radians(i * 1.0)),
           after = ivy_rim(form, radians(i + 4.0));
    if (here > before && here > after && here >= ivy_rim(form, radians(i - 1.0)) &&
        here > ivy_rim(form, radians(i + 1.0)))
      ++count;
  }
  return count;
}

TEST(IvyLeaf, HasTheLobesOfItsAge) {
  EXPECT_EQ(lobes(IvyForm::arrow), 5);
  EXPECT_EQ(lobes(IvyForm::five), 5);
  EXPECT_EQ(lobes(IvyForm::three), 3);
  EXPECT_EQ(lobes(IvyForm::heart), 1);
}

TEST(IvyLeaf, IsAMeshThatFacesUpAtAnyDetail) {
  for (int form = 0; form < kIvyForms; ++form) {
    std::size_t last = 0;
    for (int detail = 0; detail < 3; ++detail) {
      IvyLeafShape shape;
      shape.form = static_cast<IvyForm>(form);
      shape.detail = detail;
      Surface leaf = ivy_leaf_surface(shape);
      EXPECT_EQ(leaf.find_fault(), "");
      EXPECT_GT(leaf.triangle.size(), 2 * last);
      last = leaf.triangle.size();
      double area = 0;
      for (auto [a, b, c] : leaf.triangle) {
        if (leaf.uv[a].x > 1.5f) continue;  // of the petiole
        Vec3 up = glm::cross(leaf.position[b] - leaf.position[a], leaf.position[c] - leaf.position[a]);
        EXPECT_GT(up.z, -1e-5f);
        area += up.z / 2;
      }
      LeafDisc disc = ivy_disc(shape);
      EXPECT_NEAR(area, kPi * disc.radius * disc.radius, 0.15 * area);
    }
    EXPECT_LE(last, 400u);
  }
  IvyLeafShape far;
  far.detail = 0;
  EXPECT_LE(ivy_leaf_surface(far).triangle.size(), 26u);
}

TEST(IvyLeaf, PetioleRunsFromTheOriginToTheBlade) {
  IvyLeafShape shape;
  Surface leaf = ivy_leaf_surface(shape);
  Vec3 foot(0), end(0);
  int at_foot = 0, at_end = 0;
  for (std::size_t i = 0; i < leaf.position.size(); ++i) {
    if (leaf.uv[i].x == 2) foot += leaf.position[i], ++at_foot;
    if (leaf.uv[i].x == 3) end += leaf.position[i], ++at_end;
  }
  ASSERT_GT(at_foot, 2);
  EXPECT_LT(glm::length(foot / static_cast<float>(at_foot)), 0.02f);
  EXPECT_LT(glm::distance(end / static_cast<float>(at_end), ivy_attachment(shape)), 0.03f);
}

TEST(IvyLeaf, LobesLieOnTheVeinsOfTheTexture) {
  for (int form = 0; form < kIvyForms; ++form) {
    IvyLeafShape shape;
    shape.form = static_cast<IvyForm>(form);
    Surface leaf = ivy_leaf_surface(shape);
    for (double vein : {50.0, 110.0}) {
      double nearest = 1e9;
      for (std::size_t i = 0; i < leaf.uv.size(); ++i) {
        if (leaf.uv[i].x > 1.5f) continue;
        double x = (leaf.uv[i].x - 0.5) * 2.6, y = (leaf.uv[i].y - 0.5) * 2.6, r = std::hypot(x, y);
        if (r > 0.4) nearest = std::min(nearest, std::abs(degrees(std::atan2(x, y)) - vein));
      }
      EXPECT_LT(nearest, 0.5);
    }
  }
}

}  // namespace
}  // namespace frond
