#include "grove/earlier.h"

#include <gtest/gtest.h>

#include "grove/standing.h"

namespace frond {
namespace {

GrownTree grown(std::uint64_t seed, int years, bool history) {
  Seedling s;
  s.seed = Seed{seed};
  s.species.lifespan = 20;
  s.species.clear_trunk = 4;
  s.species.wood.deadwood = 1;
  GroveOptions options;
  options.years = years;
  options.history = history;
  options.wind = 50;  // so that boughs break
  return grow_grove({s}, options)[0];
}

/// Each age of a tree is the tree that has grown no longer, down to its leaves and scars.
TEST(Earlier, IsTheTreeThatHasGrownNoLonger) {
  constexpr int kYears = 24;  // it dies on the way
  for (std::uint64_t seed : {1, 5}) {
    GrownTree whole = grown(seed, kYears, true);
    ASSERT_GT(whole.scars.size(), 0u);
    for (int years : {1, 2, 7, 15, 21, kYears}) {
      GrownTree now = grown(seed, years, false), then = earlier(whole, years);
      EXPECT_EQ(then.tip, now.tip) << years;
      EXPECT_EQ(then.parent, now.parent) << years;
      EXPECT_EQ(then.radius, now.radius) << years;
      EXPECT_EQ(then.born, now.born) << years;
      EXPECT_EQ(then.died, now.died) << years;
      EXPECT_EQ(then.order, now.order) << years;
      EXPECT_EQ(then.leads, now.leads) << years;
      EXPECT_EQ(then.sizes.size(), now.sizes.size()) << years;
      ASSERT_EQ(then.scars.size(), now.scars.size()) << years;
      for (std::size_t i = 0; i < now.scars.size(); ++i) {
        EXPECT_EQ(then.scars[i].on, now.scars[i].on);
        EXPECT_EQ(then.scars[i].id, now.scars[i].id);
      }
      Standing a = standing(then, Species{}, years + 0.5, {}), b = standing(now, Species{}, years + 0.5, {});
      EXPECT_EQ(a.leaves, b.leaves) << years;
    }
  }
}

}  // namespace
}  // namespace frond
