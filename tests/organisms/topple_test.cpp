#include "organisms/tree/topple.h"

#include <gtest/gtest.h>

#include <cmath>

#include "organisms/tree/tree.h"

namespace frond {
namespace {

/// A tree that a storm overturns, as it stands then.
struct Overturned {
  TreeParams params;
  GrownTree tree;
  Standing now;

  Overturned() {
    params.years = 24;
    params.species.anchorage = 100;
    TreeSite site{&params, Vec3(0), Quat(1, 0, 0, 0), 1, Seed{8}};
    tree = grow_trees({&site, 1}, true, Seed{1}).trees[0];
    now = standing(tree, params.species, tree.uprooting.time, {});
  }
};

const Overturned& overturned() {
  static const Overturned tree;
  return tree;
}

TEST(Topple, TurnsTowardWhereTheLoadPushed) {
  const auto& [params, tree, now] = overturned();
  ASSERT_TRUE(tree.uprooting.happens());
  for (double slope : {0.0, 0.3}) {
    Fall fall = hinge_of(now, tree, [&](double x, double) { return slope * x; });
    Vec3 moved = glm::angleAxis(0.1f, fall.axis) * Vec3(0, 1, 0);
    EXPECT_GT(glm::dot(moved, tree.uprooting.toward), 0.09f);
    EXPECT_NEAR(fall.hinge.y, slope * fall.hinge.x, 1e-3) << "the edge of the plate is on the ground";
  }
}

TEST(Topple, LiesOnTheGroundFlatOrSloping) {
  const auto& [params, tree, now] = overturned();
  for (double slope : {0.0, 0.35, -0.35}) {
    GroundHeight ground = [&](double x, double z) { return slope * (x + 0.4 * z); };
    Fall fall = fall_of(now, tree, params.species, ground);
    Model model = tree_model(params, tree, tree.uprooting.time, {}, Seed{2});
    EXPECT_EQ(model.find_fault(), "");
    Pose pose;
    pose_skeleton(model.skeleton, {}, 0, pose);
    turn_fallen(fall, model.skeleton, fall.length(), ground, pose);
    float deepest = 0;
    for (std::size_t i = 0; i < model.skeleton.size(); ++i) {
      Vec3 rest = model.skeleton.position[i], at = pose.position[i];
      if (rest.y < ground(rest.x, rest.z)) continue;
      deepest = std::min(deepest, at.y - static_cast<float>(ground(at.x, at.z)));
    }
    EXPECT_GT(deepest, -0.04f) << slope;
    // Down a slope it turns farther than up one.
    double along = slope * static_cast<double>(tree.uprooting.toward.x + 0.4f * tree.uprooting.toward.z);
    EXPECT_NEAR(fall.course.back(), 1.35 - std::atan(along), 0.35) << slope;
  }
}

TEST(Topple, StrongLimbsHoldTheStemUp) {
  auto [params, tree, now] = overturned();
  GroundHeight flat = [](double, double) { return 0.0; };
  params.species.wood.strength = 1e12;
  float strong = fall_of(now, tree, params.species, flat).course.back();
  params.species.wood.strength = 1e3;
  float weak = fall_of(now, tree, params.species, flat).course.back();
  EXPECT_LT(strong, weak - 0.1f);
}

TEST(Topple, KeepsItsLeavesUntilItLies) {
  const auto& [params, tree, now] = overturned();
  Filming filming{.seconds_a_year = 0.5, .leafy = 3};
  auto leaves = [&](double after) {
    float sum = 0;
    for (float share : standing(tree, params.species, tree.uprooting.time + after, filming).leaves)
      sum += share;
    return sum;
  };
  EXPECT_GT(leaves(0), 10);
  EXPECT_EQ(leaves(6), leaves(1));
  EXPECT_LT(leaves(9), leaves(6));
  EXPECT_EQ(leaves(12.1), 0);
}

}  // namespace
}  // namespace frond
