#include <gtest/gtest.h>

#include <algorithm>

#include "crown/axes.h"
#include "crown/colonize.h"
#include "crown/weber_penn.h"

namespace frond {
namespace {

/// A stem that leans over and forks at half its way.
GuideAxes forked() {
  GuideAxes guides;
  guides.points = {{{0.2f, 1, 0}, -1},      {{0.8f, 2, 0}, 0},     {{1.9f, 2.8f, 0.2f}, 1},
                   {{3.2f, 3.2f, 0.3f}, 2}, {{0.5f, 3, -0.4f}, 1}, {{0.2f, 4, -0.6f}, 4}};
  return guides;
}

/// Metres from a place to the nearest axis.
double away(const std::vector<GuideAxis>& axes, Vec3 place) {
  double least = 1e9;
  for (const GuideAxis& axis : axes)
    for (int k = 0; k <= 400; ++k)
      least = std::min<double>(least, glm::distance(axis.point(axis.length() * k / 400), place));
  return least;
}

/// The farthest that a skeleton's nodes stay away from any place on the axes.
double unmet(const std::vector<GuideAxis>& axes, const Skeleton& s) {
  double most = 0;
  for (const GuideAxis& axis : axes)
    for (int k = 0; k <= 60; ++k) {
      Vec3 at = axis.point(axis.length() * k / 60);
      double least = 1e9;
      for (const Vec3& node : s.position) least = std::min<double>(least, glm::distance(node, at));
      most = std::max(most, least);
    }
  return most;
}

TEST(GuideAxes, GoOnAlongTheLongestWay) {
  std::vector<GuideAxis> axes = axes_of(forked());
  ASSERT_EQ(axes.size(), 2u);
  EXPECT_EQ(axes[0].at.size(), 5u);
  EXPECT_EQ(axes[0].at.front(), Vec3(0));
  EXPECT_EQ(axes[1].off, 0);
  EXPECT_EQ(axes[1].at.front(), Vec3(0.8f, 2, 0));
  EXPECT_NEAR(axes[1].from,
              glm::distance(Vec3(0), Vec3(0.2f, 1, 0)) + glm::distance(Vec3(0.2f, 1, 0), Vec3(0.8f, 2, 0)),
              1e-5);
  EXPECT_TRUE(axes_of({}).empty());
  // A point at the foot adds nothing, and the longer of two stems is the first axis.
  GuideAxes two;
  two.points = {{Vec3(0), -1}, {{0, 1, 0}, 0}, {{1, 3, 0}, 0}};
  axes = axes_of(two);
  ASSERT_EQ(axes.size(), 2u);
  EXPECT_EQ(axes[0].at.back(), Vec3(1, 3, 0));
  EXPECT_EQ(axes[1].from, 0);
}

TEST(Guided, WeberPennTrunksFollowTheirAxesAndBearByTheirLaws) {
  WeberPenn tree;
  tree.levels = 2;
  tree.level[0].length = 1, tree.level[0].curve_res = 16, tree.level[0].curve_v = radians(60.0);
  tree.level[1].branches = 30, tree.level[1].down_angle = radians(60.0), tree.level[1].length = 0.3;
  tree.guides = forked();
  std::vector<GuideAxis> axes = axes_of(tree.guides);
  for (std::uint64_t seed : {1u, 2u, 3u}) {
    Result<Crown> crown = grow_weber_penn(tree, Seed{seed});
    ASSERT_TRUE(crown);
    const Skeleton& s = crown->skeleton;
    EXPECT_EQ(s.find_fault(), "");
    double length = axes[0].length();
    int stems = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
      if (s.order[i] == 0) {
        EXPECT_LT(away(axes, s.position[i]), 0.1 * length);
        continue;
      }
      std::int32_t p = s.parent[i];
      if (p < 0 || s.order[static_cast<std::size_t>(p)] != 0) continue;
      ++stems;
    }
    EXPECT_LT(unmet(axes, s), 0.1 * length);
    EXPECT_GT(stems, 15) << "branches as many as its laws say";
    EXPECT_LT(stems, 45);
  }
}

TEST(Guided, ColonizedTreesGrowFromTheirAxes) {
  Envelope ball(EllipsoidCrown{{1.5f, 3, 0}, {2, 1.5f, 2}});
  Colonization how;
  how.attractors = 2000;
  std::vector<GuideAxis> axes = axes_of(forked());
  Result<Skeleton> s = colonize(ball, how, Seed{1}, forked());
  ASSERT_TRUE(s);
  EXPECT_EQ(s->find_fault(), "");
  EXPECT_LT(unmet(axes, *s), how.step);
  std::size_t off = 0;
  for (const Vec3& at : s->position) {
    if (away(axes, at) < how.step) continue;
    ++off;
    EXPECT_LT(glm::length((at - Vec3(1.5f, 3, 0)) / Vec3(2, 1.5f, 2)), 1 + how.step)
        << "it fills the envelope";
  }
  EXPECT_GT(off, 500u);
  // Guides that end before the envelope are gone on from.
  GuideAxes low;
  low.points = {{{1, 0.5f, 0}, -1}};
  Result<Skeleton> far = colonize(Envelope(EllipsoidCrown{{1, 6, 0}, {1, 1, 1}}), how, Seed{1}, low);
  ASSERT_TRUE(far);
  EXPECT_GT(far->size(), 100u);
}

}  // namespace
}  // namespace frond
