#include "grove/dates.h"

#include <gtest/gtest.h>

#include <numeric>

#include "grove/grove.h"

namespace frond {
namespace {

std::vector<GrownTree> grown(const Dates& dates, int trees = 1, double wind = 14) {
  std::vector<Seedling> seedlings;
  for (int i = 0; i < trees; ++i)
    seedlings.push_back({{},
                         Vec3(6.0f * static_cast<float>(i), 0, 0),
                         Vec3(0, 1, 0),
                         Seed{static_cast<std::uint64_t>(i) + 8},
                         0,
                         {},
                         i % 2 == 0 ? "oak" : "ash"});
  GroveOptions options;
  options.years = 13, options.wind = wind, options.history = true, options.dates = dates;
  return grow_grove(seedlings, options);
}

Event storm(double strength) { return {.year = 10, .storm = strength, .cut = {}, .prune = {}}; }

TEST(Dates, NothingChangesBeforeAnEvent) {
  GrownTree plain = grown({})[0], stormy = grown({{{9, storm(1)}}, {}})[0];
  for (std::size_t year = 0; year < 9; ++year)
    EXPECT_EQ(plain.sizes[year].internodes, stormy.sizes[year].internodes) << year;
}

TEST(Dates, StrongerStormsBreakMore) {
  std::size_t before = grown({})[0].broken;
  for (double strength : {0.4, 0.7, 1.0}) {
    std::size_t broken = grown({{{9, storm(strength)}}, {}})[0].broken;
    EXPECT_GE(broken, before) << strength;
    before = broken;
  }
  EXPECT_GT(before, grown({})[0].broken);
}

TEST(Dates, StormsBlowWhereTheSceneSays) {
  Dates dates{{{3, storm(0.5)}}, Vec3(0, 0, -1)};
  Weather weather = weather_of(20, 0, dates, Seed{1}, 3);
  EXPECT_NEAR(weather.wind.z, -35, 1e-3);
  EXPECT_EQ(weather_of(20, 0, dates, Seed{1}, 4).wind, weather_of(20, 0, {}, Seed{1}, 4).wind);
}

TEST(Dates, AShareOfAnEntryIsFelled) {
  Dates dates{{{9, {.year = 10, .storm = 0, .cut = Cut{"oak", 0.5}, .prune = {}}}}, Vec3(1, 0, 0)};
  std::vector<GrownTree> trees = grown(dates, 8);
  int felled = 0;
  for (std::size_t i = 0; i < trees.size(); ++i) {
    const Uprooting& fall = trees[i].uprooting;
    felled += fall.happens();
    if (!fall.happens()) continue;
    EXPECT_EQ(i % 2, 0u) << "ashes stay";
    EXPECT_TRUE(fall.felled);
    EXPECT_GT(fall.moment, fall.hold);
    EXPECT_EQ(fall.toward, Vec3(1, 0, 0));
  }
  EXPECT_EQ(felled, 2);
}

TEST(Dates, PruningLeavesNoLimbBelow) {
  Dates dates{{{11, {.year = 12, .storm = 0, .cut = {}, .prune = Prune{"", 2.5}}}}, {}};
  auto low_limbs = [](const GrownTree& t, float from) {
    int count = 0;
    for (std::size_t i = 1; i < t.size(); ++i)
      count +=
          t.order[i] == 1 && t.order[t.parent[i]] == 0 && t.fell[i] > from && t.tip[t.parent[i]].y < 2.5f;
    return count;
  };
  EXPECT_GT(low_limbs(grown({})[0], 12.95f), 0);
  EXPECT_EQ(low_limbs(grown(dates)[0], 12.95f), 0);
}

}  // namespace
}  // namespace frond
