#include "crown/along_parent.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frond {
namespace {

/// A stem of four metres with branches of one metre at right angles in each, which bear a twig each.
struct Plant {
  Skeleton s;
  std::vector<AxisNode> axes;
  std::vector<std::int32_t> foot, tip, twig;

  Plant() {
    s.add(Vec3(0), 0.1f, Skeleton::kRoot, 0), axes.push_back({1, 0});
    for (int i = 1; i <= 4; ++i) {
      s.add(Vec3(0, i, 0), 0.1f, i - 1, 0);
      axes.push_back({0, static_cast<float>(i) / 4});
    }
    for (int i = 1; i <= 4; ++i) {
      std::int32_t below = i;
      for (float k = 1; k <= 2; ++k) {
        below = s.add(Vec3(0.5f * k, i, 0), 0.04f, below, 1);
        axes.push_back({k == 1 ? i : 0, k / 2});
        if (k == 1) foot.push_back(below);
      }
      tip.push_back(below);
      twig.push_back(s.add(Vec3(0.5f, i, 0.3f), 0.01f, foot.back(), 2));
      axes.push_back({1, 1});
    }
  }
  ShapedAlong shaped(const BranchesAlong& by) const {
    return shape_along(s.parent, axes, s.position, s.radius, by);
  }
};

TEST(AlongParent, ACurveOf1EverywhereChangesNoBit) {
  const Plant plant;
  BranchesAlong by;
  EXPECT_TRUE(by.even());
  by.branches.length = by.twigs.angle = Curve({{0, 1}, {0.3f, 1}, {1, 1}});
  EXPECT_TRUE(by.even());
  const ShapedAlong to = plant.shaped(by);
  EXPECT_EQ(to.position, plant.s.position);
  EXPECT_EQ(to.radius, std::vector<float>(plant.s.size(), 1));
}

TEST(AlongParent, TheLengthOfABranchIsThatOfTheCurveWhereItLeaves) {
  const Plant plant;
  BranchesAlong by;
  by.branches.length = Curve({{0, 1}, {1, 0.5f}});
  const ShapedAlong to = plant.shaped(by);
  for (std::size_t b = 0; b < 4; ++b) {
    const float height = static_cast<float>(b + 1), factor = 1 - 0.5f * height / 4;
    EXPECT_NEAR(glm::distance(to.position[plant.tip[b]], Vec3(0, height, 0)), factor, 1e-5f);
    EXPECT_NEAR(glm::distance(to.position[plant.twig[b]], to.position[plant.foot[b]]), 0.3f * factor, 1e-5f)
        << "what it bears is shorter, too";
    EXPECT_EQ(to.position[b + 1], plant.s.position[b + 1]) << "the stem stays";
  }
  by = {};
  by.twigs.length = Curve({{0, 0.5f}, {1, 0.5f}});
  EXPECT_EQ(plant.shaped(by).position[plant.tip[0]], plant.s.position[plant.tip[0]]);
  EXPECT_NEAR(glm::distance(plant.shaped(by).position[plant.twig[0]], plant.s.position[plant.foot[0]]), 0.15f,
              1e-5f);
}

TEST(AlongParent, TheAngleFromTheParentIsMultiplied) {
  const Plant plant;
  BranchesAlong by;
  by.branches.angle = Curve({{0, 1.5f}, {1, 0.5f}});
  const ShapedAlong to = plant.shaped(by);
  for (std::size_t b = 0; b < 4; ++b) {
    const Vec3 out = glm::normalize(to.position[plant.tip[b]] - Vec3(0, b + 1, 0));
    const double place = static_cast<double>(b + 1) / 4;
    EXPECT_NEAR(std::acos(out.y), radians(90.0) * (1.5 - place), 1e-4) << place;
    // A twig goes with it, in the same shape.
    EXPECT_NEAR(glm::distance(to.position[plant.twig[b]], to.position[plant.tip[b]]), std::hypot(0.5, 0.3),
                1e-5);
  }
}

TEST(AlongParent, NoBranchBecomesThickerThanItsParentNorVanishes) {
  const Plant plant;
  BranchesAlong by;
  by.branches.radius = Curve({{0, 8}, {1, 8}});
  EXPECT_NEAR(plant.shaped(by).radius[plant.tip[1]] * 0.04f, 0.1f, 1e-6f);
  by.branches.radius = Curve({{0, 0.5f}, {1, 0.5f}});
  EXPECT_NEAR(plant.shaped(by).radius[plant.twig[1]], 0.5f, 1e-6f);
  by.branches.length = by.branches.angle = by.branches.radius = Curve({{0, 0}, {1, 0}});
  const ShapedAlong to = plant.shaped(by);
  for (std::size_t i = 0; i < plant.s.size(); ++i) {
    EXPECT_TRUE(std::isfinite(to.position[i].x + to.position[i].y + to.position[i].z));
    EXPECT_GT(to.radius[i], 0);
  }
  EXPECT_NEAR(to.position[plant.tip[0]].y, 1.05f, 1e-5f) << "along the stem";
}

}  // namespace
}  // namespace frond
