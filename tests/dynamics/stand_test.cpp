#include "dynamics/stand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/parallel.h"
#include "dynamics/plots.h"

namespace frond {
namespace {

/// A planted stand of one species on 60 x 60 m without storms.
StandOptions even_aged(TreeName name, int years, double density = 8000) {
  StandOptions options;
  options.area = {60, 60}, options.years = years, options.species = {species(name)};
  options.planted = {{name, density}};
  options.seeding = false, options.storms = 0;
  return options;
}

struct StandMean {
  double top = 0;       // metres, of the 100 highest a hectare
  double diameter = 0;  // cm, of the mean basal area
};

StandMean mean_at(const StandHistory& history, double year) {
  std::vector<double> heights;
  double squares = 0;
  for (std::uint32_t i : living_at(history, year)) {
    TreeSize size = size_at(history, i, year);
    heights.push_back(static_cast<double>(size.height));
    squares += static_cast<double>(size.diameter * size.diameter);
  }
  std::ranges::sort(heights, std::greater());
  auto count = std::min<std::size_t>(heights.size(), 36);
  StandMean mean;
  for (std::size_t i = 0; i < count; ++i) mean.top += heights[i] / static_cast<double>(count);
  mean.diameter = 100 * std::sqrt(squares / static_cast<double>(std::max<std::size_t>(heights.size(), 1)));
  return mean;
}

/// Slope of the least squares through points.
double slope_of(const std::vector<std::pair<double, double>>& points) {
  double n = static_cast<double>(points.size()), x = 0, y = 0, xx = 0, xy = 0;
  for (auto [a, b] : points) x += a, y += b, xx += a * a, xy += a * b;
  return (n * xy - x * y) / (n * xx - x * x);
}

/// Yoda et al. 1963: mean mass in proportion to density^-3/2; Reineke 1933 and Pretzsch 2006 found -1.2 to
/// -1.8 by species. From crown closure on, until the trees begin to die of age.
TEST(Stand, EvenAgedStandsThinThemselves) {
  const std::pair<TreeName, int> rows[] = {
      {TreeName::pine, 70}, {TreeName::beech, 100}, {TreeName::spruce, 100}, {TreeName::fir, 100}};
  for (auto [name, last] : rows) {
    StandHistory history = simulate_stand(even_aged(name, last), level_land(), Seed{1});
    std::vector<std::pair<double, double>> course;
    for (int year = 20; year <= last; year += 5) {
      StandFigures f = figures_at(history, year);
      if (f.density < 5000) course.emplace_back(std::log(f.density), std::log(f.mean_mass));
    }
    double slope = slope_of(course);
    EXPECT_LT(slope, -1.2) << name_of(name);
    EXPECT_GT(slope, -1.8) << name_of(name);
  }
}

/// Top heights at an age: Edwards and Christie 1981, yield classes 6 of oak, 8 of beech and birch, 10 of
/// Scots pine, 16 of Norway spruce, each with the class above and below. Diameters at 100 years, of birch at
/// 50, and the basal area of stands that are hardly thinned: Schober 1975, Assmann 1970.
TEST(Stand, HeightsDiametersAndBasalAreasAreThoseOfYieldTables) {
  struct Row {
    TreeName name;
    double low20, high20, low50, high50, low100, high100;
    double thin, thick, least, most;
  };
  const Row rows[] = {{TreeName::birch, 9, 13.5, 17, 23, 22, 26, 15, 24, 25, 55},
                      {TreeName::oak, 6, 10, 14, 19, 20, 26, 25, 35, 28, 45},
                      {TreeName::pine, 7, 11, 17, 22, 23, 29, 26, 36, 40, 60},
                      {TreeName::beech, 6, 10, 16, 23, 26, 34, 26, 37, 38, 60},
                      {TreeName::spruce, 7, 11, 19, 25, 28, 36, 30, 42, 60, 95}};
  for (const Row& row : rows) {
    StandHistory history = simulate_stand(even_aged(row.name, 100), level_land(), Seed{1});
    double born = age_at(species(row.name), 1.3);
    auto top = [&](double age) { return mean_at(history, age - born).top; };
    int year = row.name == TreeName::birch ? 45 : 100;
    EXPECT_GT(top(20), row.low20) << name_of(row.name);
    EXPECT_LT(top(20), row.high20) << name_of(row.name);
    EXPECT_GT(top(50), row.low50) << name_of(row.name);
    EXPECT_LT(top(50), row.high50) << name_of(row.name);
    EXPECT_GT(top(100), row.low100) << name_of(row.name);
    EXPECT_LT(top(100), row.high100) << name_of(row.name);
    double diameter = mean_at(history, year).diameter, basal = figures_at(history, year).basal_area[0];
    EXPECT_GT(diameter, row.thin) << name_of(row.name);
    EXPECT_LT(diameter, row.thick) << name_of(row.name);
    EXPECT_GT(basal, row.least) << name_of(row.name);
    EXPECT_LT(basal, row.most) << name_of(row.name);
  }
}

/// Mitchell's rule (White 1998): 2.5 cm of girth a year in the open, half of that in a wood. Height over
/// diameter is 25 to 50 in the open and 80 to 120 in dense stands (Hasenauer 1997, Mitscherlich 1978).
TEST(Stand, TreesInTheOpenAreStoutAndTreesOfAStandSlender) {
  for (TreeName name : {TreeName::oak, TreeName::beech, TreeName::spruce, TreeName::pine}) {
    StandHistory free = simulate_stand(even_aged(name, 80, 3), level_land(), Seed{4});
    StandHistory dense = simulate_stand(even_aged(name, 80), level_land(), Seed{4});
    ASSERT_FALSE(living_at(free, 80).empty());
    TreeSize tree = size_at(free, living_at(free, 80)[0], 80);
    double girth_gain = kPi * 100 * static_cast<double>(tree.diameter) / 80;
    EXPECT_NEAR(girth_gain, species(name).girth_gain, 0.4 * species(name).girth_gain) << name_of(name);
    EXPECT_LT(tree.height / tree.diameter, 50) << name_of(name);
    EXPECT_LT(tree.crown_base, 0.35f * tree.height) << name_of(name);
    float slender = 0, base = 0;
    std::vector<std::uint32_t> living = living_at(dense, 80);
    for (std::uint32_t i : living) {
      TreeSize size = size_at(dense, i, 80);
      slender += size.height / size.diameter / static_cast<float>(living.size());
      base += size.crown_base / size.height / static_cast<float>(living.size());
    }
    EXPECT_GT(slender, 75) << name_of(name);
    EXPECT_LT(slender, 125) << name_of(name);
    EXPECT_GT(base, 0.6f) << name_of(name);
  }
}

/// Half of the seeds lie within the reach; of those on the wind one in ten flies three times as far, of those
/// that fall 1.8 times (Clark et al. 1999).
TEST(Stand, SeedsLieWhereTheirCarrierTakesThem) {
  for (const TreeSpecies& tree : tree_species()) {
    EXPECT_NEAR(seed_distance(tree, 0.5), tree.reach, 1e-3 * tree.reach) << name_of(tree.name);
    for (double q = 0; q < 0.99; q += 0.01) EXPECT_LT(seed_distance(tree, q), seed_distance(tree, q + 0.01));
    double far = seed_distance(tree, 0.9) / tree.reach;
    double expected = tree.carrier == SeedCarrier::wind      ? 3
                      : tree.carrier == SeedCarrier::animals ? 3.8897 / 1.6783
                                                             : std::sqrt(std::log(10) / std::log(2));
    EXPECT_NEAR(far, expected, 1e-3) << name_of(tree.name);
  }
}

TEST(Stand, StrongerStormsThrowMore) {
  double before = -1;
  for (double strength : {0.0, 0.3, 0.6, 0.8, 1.0}) {
    int thrown = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      StandOptions options = even_aged(TreeName::spruce, 61, 3000);
      options.area = {50, 50};
      options.events = {{60, strength, {}, 0}};
      for (const TreeLife& life : simulate_stand(options, level_land(), Seed{seed}).lives)
        if (life.died > 59 && life.died < 60)
          thrown += life.cause == DeathCause::storm || life.cause == DeathCause::struck;
    }
    EXPECT_GT(thrown, before) << strength;
    before = thrown + (strength == 0 ? -1 : 0);
  }
  EXPECT_GT(before, 100);
}

/// What is thrown falls as the wind blows, and stems lie beside each other.
TEST(Stand, StormsThrowToOneSide) {
  StandOptions options = even_aged(TreeName::spruce, 61, 3000);
  options.events = {{60, 1, {}, 0}};
  double x = 0, z = 0;
  int count = 0;
  for (const TreeLife& life : simulate_stand(options, level_land(), Seed{2}).lives)
    if (life.cause == DeathCause::storm)
      ++count, x += std::sin(static_cast<double>(life.azimuth)),
          z += std::cos(static_cast<double>(life.azimuth));
  ASSERT_GT(count, 20);
  EXPECT_GT(std::hypot(x, z) / count, 0.9);
}

TEST(Stand, IsTheSameAtAnyNumberOfThreads) {
  // Of so many cells as in the second the light is also shared by threads.
  for (auto [cell, years] : {std::pair(2.0, 60), {0.4, 12}}) {
    StandOptions options;
    options.area = {60, 60}, options.cell = cell, options.years = years;
    options.species.assign(tree_species().begin(), tree_species().end());
    options.events = {{50, 0.9, {}, 0}};
    auto history = [&](int threads) {
      limit_threads(threads);
      return simulate_stand(options, level_land(), Seed{1});
    };
    StandHistory one = history(1), two = history(2);
    limit_threads(0);
    ASSERT_EQ(one.lives.size(), two.lives.size());
    ASSERT_GT(one.lives.size(), 100u);
    ASSERT_EQ(one.sizes.size(), two.sizes.size());
    EXPECT_EQ(std::memcmp(one.sizes.data(), two.sizes.data(), one.sizes.size() * sizeof(TreeSize)), 0);
    for (std::size_t i = 0; i < one.lives.size(); ++i) {
      ASSERT_EQ(one.lives[i].died, two.lives[i].died) << i;
      ASSERT_EQ(one.lives[i].azimuth, two.lives[i].azimuth) << i;
    }
  }
}

/// Above 6.4 degrees and what each species bears nothing grows, and trees become lower toward it.
TEST(Stand, AMountainHasATreeLine) {
  StandOptions options = even_aged(TreeName::spruce, 100, 2000);
  options.area = {40, 200};
  // From 12.8 degrees to 5: the line is at 6.8, at z = 57.
  auto slope = [](double, double z) { return StandGround{(z + 100) * 6, 0.6}; };
  StandHistory history = simulate_stand(options, slope, Seed{1});
  double low = 0, high = 0;
  for (std::uint32_t i : living_at(history, 100)) {
    auto z = static_cast<double>(history.lives[i].z),
         height = static_cast<double>(size_at(history, i, 100).height);
    EXPECT_LT(z, 57);
    (z < 0 ? low : high) = std::max(z < 0 ? low : high, z > 0 && z < 40 ? 0 : height);
  }
  EXPECT_GT(low, 30);
  EXPECT_GT(high, 3);
  EXPECT_LT(high, 0.7 * low);
}

/// Sizes have no jumps over the years, and what has died stays as it was.
TEST(Stand, SizesAreContinuous) {
  StandHistory history = simulate_stand(even_aged(TreeName::birch, 60), level_land(), Seed{1});
  for (std::uint32_t i = 0; i < history.lives.size(); i += 97) {
    TreeSize before = size_at(history, i, -5);
    for (double year = -5; year < 60; year += 0.05) {
      TreeSize now = size_at(history, i, year);
      ASSERT_NEAR(now.height, before.height, 0.12) << i << " in " << year;
      ASSERT_NEAR(now.diameter, before.diameter, 0.002) << i << " in " << year;
      ASSERT_GE(now.height + 1e-4f, before.height);
      ASSERT_LE(now.crown_base, now.height);
      before = now;
    }
  }
}

TEST(Stand, FellingTakesAShareOfOneSpecies) {
  StandOptions options = even_aged(TreeName::pine, 12, 1000);
  options.species.push_back(species(TreeName::oak));
  options.planted.push_back({TreeName::oak, 1000});
  options.events = {{.year = 10, .cut = TreeName::pine, .share = 0.5}};
  StandHistory history = simulate_stand(options, level_land(), Seed{1});
  int cut = 0;
  for (const TreeLife& life : history.lives) {
    if (life.cause != DeathCause::cut) continue;
    ++cut;
    EXPECT_EQ(life.species, 0u);
    EXPECT_EQ(life.rotted, life.died);
  }
  EXPECT_NEAR(cut, 180, 30);
}

TEST(Stand, PruningRaisesTheCrownsOfItsSpecies) {
  StandOptions options = even_aged(TreeName::pine, 30, 400);
  options.species.push_back(species(TreeName::oak));
  options.planted.push_back({TreeName::oak, 400});
  auto bases = [&](std::uint32_t kind, double year) {
    StandHistory history = simulate_stand(options, level_land(), Seed{1});
    std::vector<float> list;
    for (std::uint32_t i : living_at(history, year))
      if (history.lives[i].species == kind) list.push_back(size_at(history, i, year).crown_base);
    return list;
  };
  std::vector<float> before = bases(0, 20), oaks = bases(1, 20);
  options.events = {{.year = 20, .pruned = TreeName::pine, .below = 3}};
  std::vector<float> after = bases(0, 20);
  auto low = [](const std::vector<float>& list) {
    return std::ranges::count_if(list, [](float b) { return b < 2.9f; });
  };
  EXPECT_GT(low(before), std::ssize(before) / 4);
  EXPECT_LT(low(after), std::ssize(after) / 20);
  EXPECT_GE(low(bases(1, 20)), low(oaks));  // which get more light
}

}  // namespace
}  // namespace frond
