#include "grove/uproot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "grove/grove.h"

namespace frond {
namespace {

GrownTree grown(double anchorage, double wind, bool history = false) {
  Seedling s;
  s.seed = Seed{8};
  s.species.anchorage = anchorage;
  GroveOptions options;
  options.years = 16;
  options.wind = wind;
  options.history = history;
  return grow_grove({s}, options)[0];
}

/// A pole of ten internodes that leans by an angle.
Metamers pole(double lean) {
  Metamers m;
  m.resize(11);
  for (std::size_t i = 0; i < m.size(); ++i) {
    m.tip[i] = static_cast<float>(i) * Vec3(std::sin(lean), std::cos(lean), 0);
    m.parent[i] = static_cast<std::int32_t>(i) - 1;
    m.pipe[i] = 200;
    m.flags[i] = m.order[i] = 0;
    m.died[i] = Metamers::kNever;
  }
  return m;
}

TEST(Uproot, MomentOfAPoleIsItsWeightTimesItsLever) {
  Species s;
  s.leaf_area = 0, s.anchorage = 100;
  Metamers m = pole(0.3);
  double r = pipe_radius(s.wood, 200), mass = 10 * kPi * r * r * s.wood.density;
  EXPECT_NEAR(held_moment(m, s), 100 * mass, 0.001 * mass);
  std::vector<float> radius(m.size(), static_cast<float>(r)), none(m.size());
  Vec3 moment = moment_at_foot({m.tip, m.parent, radius, none}, s.wood, {});
  EXPECT_NEAR(glm::length(moment), mass * 9.81 * 5 * std::sin(0.3), 0.001 * mass * 9.81 * 5);
}

/// Its lever is 5 m sin(lean), so it falls by its weight alone where 9.81 x 5 sin(lean) passes the anchorage.
TEST(Uproot, FallsExactlyWhereTheMomentPassesWhatTheRootsHold) {
  Species s;
  s.leaf_area = 0;
  for (double lean : {0.1, 0.3, 0.6}) {
    double limit = 9.81 * 5 * std::sin(lean);
    for (double share : {0.9, 0.99, 1.01, 1.1}) {
      s.anchorage = share * limit;
      Uprooting fall = uprooting_of(pole(lean), s, {}, 4);
      EXPECT_EQ(fall.happens(), share < 1) << lean << " " << share;
      EXPECT_EQ(fall.happens(), fall.moment > fall.hold);
      if (fall.happens()) {
        EXPECT_GT(fall.toward.x, 0.999f) << "the way that it leans";
        EXPECT_GT(fall.time, 5);
      }
    }
  }
}

TEST(Uproot, WithoutAnAnchorageNoStormOverturns) {
  GrownTree plain = grown(0, 60), strong = grown(1e6, 60);
  EXPECT_FALSE(plain.uprooting.happens());
  EXPECT_FALSE(strong.uprooting.happens());
  EXPECT_EQ(plain.tip, strong.tip);
}

TEST(Uproot, AWeakHoldFailsInAStormAndThenNothingGrows) {
  GrownTree tree = grown(60, 40), again = grown(60, 40);
  ASSERT_TRUE(tree.uprooting.happens());
  EXPECT_GT(tree.uprooting.moment, tree.uprooting.hold);
  EXPECT_EQ(tree.uprooting.time, again.uprooting.time);
  EXPECT_EQ(tree.tip, again.tip);
  EXPECT_EQ(tree.sizes.size(), 16u);
  for (std::size_t i = 0; i < tree.size(); ++i) {
    EXPECT_LE(tree.born[i], tree.uprooting.time);
    EXPECT_LE(tree.died[i], tree.uprooting.time);
    EXPECT_EQ(tree.fell[i], GrownTree::kNever) << "what stood then stays on it";
  }
}

TEST(Uproot, WhereItStoodItShadesNobody) {
  Seedling leaning, beside;
  leaning.seed = Seed{8}, beside.seed = Seed{9};
  leaning.species.anchorage = 60;
  beside.foot = Vec3(1.5f, 0, 0);
  GroveOptions options;
  options.years = 20, options.wind = 40;
  std::vector<GrownTree> fallen = grow_grove({leaning, beside}, options);
  leaning.species.anchorage = 0;
  std::vector<GrownTree> standing = grow_grove({leaning, beside}, options);
  ASSERT_TRUE(fallen[0].uprooting.happens());
  EXPECT_GT(fallen[1].grown, standing[1].grown);
}

}  // namespace
}  // namespace frond
