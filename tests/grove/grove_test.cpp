#include "grove/grove.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/parallel.h"
#include "grove/bodies.h"
#include "solids.h"

namespace frond {
namespace {

Seedling seedling(Vec3 foot, std::uint64_t seed) {
  Seedling s;
  s.foot = foot;
  s.seed = Seed{seed};
  return s;
}

std::vector<Seedling> row(int count, float gap) {
  std::vector<Seedling> list;
  for (int i = 0; i < count; ++i)
    list.push_back(seedling(Vec3(gap * static_cast<float>(i), 0, 0), 100 + static_cast<std::uint64_t>(i)));
  return list;
}

bool lives(const GrownTree& t, std::size_t i) { return t.died[i] == GrownTree::kNever; }

std::size_t living(const GrownTree& t) {
  std::size_t count = 0;
  for (std::size_t i = 1; i < t.size(); ++i) count += lives(t, i);
  return count;
}

float height(const GrownTree& t) {
  float top = 0;
  for (std::size_t i = 0; i < t.size(); ++i) top = std::max(top, t.tip[i].y - t.tip[0].y);
  return top;
}

double leaf_area(const GrownTree& t, const Species& s, int years) {
  double sum = 0;
  for (std::size_t i = 1; i < t.size(); ++i)
    sum += t.bears_leaves(s, i, static_cast<float>(years)) * s.leaf_area;
  return sum;
}

void expect_equal(const GrownTree& a, const GrownTree& b) {
  EXPECT_EQ(a.tip, b.tip);
  EXPECT_EQ(a.radius, b.radius);
  EXPECT_EQ(a.parent, b.parent);
  EXPECT_EQ(a.born, b.born);
  EXPECT_EQ(a.died, b.died);
  EXPECT_EQ(a.fell, b.fell);
  EXPECT_EQ(a.ring, b.ring);
}

TEST(Grove, ATreeGrowsUpWithBranches) {
  GroveOptions options;
  options.years = 22;
  GrownTree t = grow_grove({seedling(Vec3(2, 1, -3), 5)}, options)[0];
  EXPECT_EQ(t.tip[0], Vec3(2, 1, -3));
  EXPECT_GT(height(t), 6);
  EXPECT_LT(height(t), 30);
  EXPECT_GT(living(t), 2000u);
  int most = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    ASSERT_LT(t.parent[i], static_cast<std::int32_t>(i));
    ASSERT_GT(t.radius[i], 0);
    most = std::max<int>(most, t.order[i]);
    if (i > 0) {
      ASSERT_GE(t.radius[t.parent[i]], t.radius[i] * 0.999f);
      ASSERT_GE(t.born[i], t.born[t.parent[i]]);
    }
  }
  EXPECT_GE(most, 3);
}

TEST(Grove, SameBytesAtAnyNumberOfThreads) {
  GroveOptions options;
  options.years = 16;
  options.history = true;
  std::vector<Seedling> list = row(5, 3);
  limit_threads(1);
  std::vector<GrownTree> one = grow_grove(list, options);
  limit_threads(2);
  std::vector<GrownTree> two = grow_grove(list, options);
  limit_threads(0);
  for (std::size_t i = 0; i < list.size(); ++i) expect_equal(one[i], two[i]);
}

/// The tree of a film is that of the still, with what has gone.
std::size_t standing_on(const std::vector<GrownTree>& trees) {
  std::size_t sum = 0;
  for (const GrownTree& t : trees) sum += t.sizes.empty() ? 0 : t.sizes.back().internodes;
  return sum;
}

TEST(Grove, ABudgetEndsGrowthWithTheLastYearThatItAllows) {
  std::vector<Seedling> list = row(3, 2);
  list[2].planted = 4;
  for (std::size_t most : {60u, 700u, 3000u}) {
    GroveOptions options;
    options.years = 40, options.most_internodes = most, options.history = most == 700;
    std::vector<GrownTree> held = grow_grove(list, options);
    auto years = static_cast<int>(held[0].sizes.size());
    ASSERT_GT(years, 1);
    ASSERT_LT(years, 40);
    EXPECT_LE(standing_on(held), most);
    // It is the grove of so many years, and one more would have passed the budget.
    options.years = years, options.most_internodes = 0;
    std::vector<GrownTree> plain = grow_grove(list, options);
    for (std::size_t i = 0; i < list.size(); ++i) expect_equal(held[i], plain[i]);
    options.years = years + 1;
    EXPECT_GT(standing_on(grow_grove(list, options)), most);
  }
}

TEST(Grove, ABudgetHoldsAtAnyNumberOfThreads) {
  GroveOptions options;
  options.years = 40, options.most_internodes = 2000;
  limit_threads(1);
  std::vector<GrownTree> one = grow_grove(row(4, 2), options);
  limit_threads(0);
  std::vector<GrownTree> all = grow_grove(row(4, 2), options);
  for (std::size_t i = 0; i < one.size(); ++i) expect_equal(one[i], all[i]);
}

TEST(Grove, ABudgetLeavesAtLeastOneYearAndMayBeTooLargeToCount) {
  GroveOptions options;
  options.years = 6, options.most_internodes = 1;
  EXPECT_EQ(grow_grove(row(1, 1), options)[0].sizes.size(), 1u);
  options.most_internodes = SIZE_MAX;
  EXPECT_EQ(grow_grove(row(1, 1), options)[0].sizes.size(), 6u);
}

TEST(Grove, HistoryChangesNothing) {
  GroveOptions options;
  options.years = 18;
  GrownTree still = grow_grove(row(1, 0), options)[0];
  options.history = true;
  GrownTree film = grow_grove(row(1, 0), options)[0];
  std::vector<Vec3> standing;
  for (std::size_t i = 0; i < film.size(); ++i)
    if (film.fell[i] == GrownTree::kNever) standing.push_back(film.tip[i]);
  EXPECT_EQ(standing, still.tip);
  EXPECT_EQ(film.size(), film.grown + 1) << "nothing that ever grew is missing";
}

TEST(Grove, HistoryIsInOrder) {
  GroveOptions options;
  options.years = 18;
  options.history = true;
  GrownTree t = grow_grove(row(1, 0), options)[0];
  std::size_t fallen = 0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    std::int32_t p = t.parent[i];
    ASSERT_LE(t.fell[i], t.fell[p]) << "a branch goes with what bears it";
    ASSERT_GE(t.died[i], t.born[i]);
    ASSERT_GE(t.fell[i], t.died[i]);
    fallen += t.fell[i] < GrownTree::kNever;
    std::uint32_t from = t.first_ring[i], to = t.first_ring[i + 1];
    ASSERT_GT(to, from);
    for (std::uint32_t k = from + 1; k < to; ++k) ASSERT_GE(t.ring[k], t.ring[k - 1]) << "radii never shrink";
    ASSERT_FLOAT_EQ(t.ring[to - 1], t.radius[i]);
  }
  EXPECT_GT(fallen, 100u);
}

TEST(Grove, BoughsThatFallLeaveScars) {
  GroveOptions options;
  options.years = 40;
  std::vector<Seedling> one = row(1, 0);
  one[0].species.clear_trunk = 8;
  GrownTree still = grow_grove(one, options)[0];
  options.history = true;
  GrownTree film = grow_grove(one, options)[0];
  std::size_t standing = 0, boughs = 0;
  for (const Scar& scar : film.scars) standing += film.fell[scar.on] == GrownTree::kNever;
  EXPECT_EQ(still.scars.size(), standing) << "a still shows those that are left";
  auto twig = static_cast<float>(Species{}.wood.twig_radius);
  for (std::size_t i = 1; i < film.size(); ++i) {
    std::int32_t p = film.parent[i];
    bool breaks = film.fell[i] < film.fell[p] && film.order[i] > film.order[p];
    boughs += breaks && film.radius[i] >= 5 * twig;
  }
  EXPECT_EQ(film.scars.size(), boughs);
  ASSERT_GT(still.scars.size(), 5u);
  for (const Scar& scar : film.scars) {
    ASSERT_NEAR(glm::length(scar.direction), 1, 1e-4f);
    ASSERT_GE(scar.fell, film.born[scar.on]);
    ASSERT_LE(scar.girth, film.radius[scar.on] * 1.001f) << "what bore it has grown on";
  }
}

/// Beside a dark wall a tree leans away and has fewer living branches on that side.
TEST(Grove, ATreeLeansAwayFromAWall) {
  int away = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    GroveOptions options;
    options.years = 18;
    options.bodies = shades_of_body(box(Vec3(-2.5f, 0, -8), Vec3(-1, 12, 8)), options.light);
    Seedling s = seedling(Vec3(0), seed);
    s.species.clear_trunk = 0;
    GrownTree t = grow_grove({s}, options)[0];
    double middle = 0;
    std::size_t dark = 0, bright = 0;
    for (std::size_t i = 1; i < t.size(); ++i) {
      if (!lives(t, i)) continue;
      middle += t.tip[i].x;
      ++(t.tip[i].x < 0 ? dark : bright);
    }
    EXPECT_GT(middle / static_cast<double>(living(t)), 0.25) << "seed " << seed;
    EXPECT_LT(2 * dark, bright) << "seed " << seed;
    options.bodies.clear();
    GrownTree open = grow_grove({s}, options)[0];
    double centre = 0;
    for (std::size_t i = 1; i < open.size(); ++i) centre += lives(open, i) ? open.tip[i].x : 0;
    away += std::abs(centre / static_cast<double>(living(open))) < middle / static_cast<double>(living(t));
  }
  EXPECT_GE(away, 3) << "the wall, not chance, made them lean";
}

/// Of the half-metre cells that two neighbours fill with living shoots, few hold both of them.
double shared_cells(const GrownTree& a, const GrownTree& b) {
  std::map<std::array<int, 3>, int> cells;
  for (const GrownTree* t : {&a, &b})
    for (std::size_t i = 1; i < t->size(); ++i)
      if (lives(*t, i) && t->order[i] > 0)
        cells[{static_cast<int>(std::floor(t->tip[i].x * 2)), static_cast<int>(std::floor(t->tip[i].y * 2)),
               static_cast<int>(std::floor(t->tip[i].z * 2))}] |= t == &a ? 1 : 2;
  double both = 0;
  for (const auto& [cell, who] : cells) both += who == 3;
  return both / static_cast<double>(cells.size());
}

TEST(Grove, CrownsKeepOutOfEachOther) {
  GroveOptions options;
  options.years = 22;
  std::vector<Seedling> list = row(2, 2);
  std::vector<GrownTree> together = grow_grove(list, options);
  GrownTree first = grow_grove({list[0]}, options)[0], second = grow_grove({list[1]}, options)[0];
  double apart = shared_cells(first, second), grown = shared_cells(together[0], together[1]);
  EXPECT_GT(apart, 0.2) << "else they had no need to";
  EXPECT_LT(grown, 0.15);
  EXPECT_LT(grown, 0.6 * apart);
}

TEST(Grove, NeighboursMakeTreesSmallAndBare) {
  GroveOptions options;
  options.years = 20;
  std::vector<Seedling> list;
  for (int i = 0; i < 9; ++i)
    list.push_back(seedling(Vec3(static_cast<float>(i % 3 - 1) * 2, 0, static_cast<float>(i / 3 - 1) * 2),
                            static_cast<std::uint64_t>(i)));
  std::vector<GrownTree> wood = grow_grove(list, options);
  GrownTree alone = grow_grove({list[4]}, options)[0];
  EXPECT_LT(living(wood[4]), living(alone) / 2);
}

/// Leaves are what light was turned into: over trees in all kinds of shade their area goes with it.
TEST(Grove, LeavesGoWithLight) {
  std::vector<double> leaves, light;
  for (int gap : {2, 3, 4, 6, 12}) {
    GroveOptions options;
    options.years = 16;
    std::vector<Seedling> list = row(3, static_cast<float>(gap));
    GrownTree t = grow_grove(list, options)[1];
    double gathered = 0;
    for (std::size_t i = 1; i < t.size(); ++i) gathered += lives(t, i) && t.leads[i] ? t.light[i] : 0;
    leaves.push_back(leaf_area(t, list[1].species, options.years));
    light.push_back(gathered);
  }
  double ratio = leaves.back() / light.back();
  EXPECT_GT(leaves.back(), 1.5 * leaves.front());
  for (std::size_t i = 0; i < leaves.size(); ++i) EXPECT_NEAR(leaves[i] / light[i], ratio, 0.35 * ratio);
}

/// r^n of a branch is the sum of those it parts into and its own leaf's, where nothing was ever shed; more
/// than that where pipes of the shed remain or the stem braced itself.
TEST(Grove, ForksKeepTheirPipes) {
  GroveOptions options;
  options.years = 16;
  options.history = true;
  Seedling s = seedling(Vec3(0), 4);
  GrownTree t = grow_grove({s}, options)[0];
  double n = s.species.wood.exponent, twig = std::pow(s.species.wood.twig_radius, n);
  std::vector<double> carried(t.size(), 0);
  std::vector<std::uint8_t> lost(t.size(), 0);
  for (std::size_t i = t.size(); i-- > 1;) {
    std::int32_t p = t.parent[i];
    lost[p] = lost[p] || lost[i] || t.fell[i] < GrownTree::kNever;
    if (t.fell[i] == GrownTree::kNever) carried[p] += std::pow(t.radius[i], n) / twig;
  }
  std::size_t forks = 0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (t.fell[i] < GrownTree::kNever || carried[i] == 0) continue;
    double own = std::pow(t.radius[i], n) / twig;
    ASSERT_GE(own, (carried[i] + kLeafPipe) * 0.999);
    if (lost[i] || t.order[i] == 0) continue;
    EXPECT_NEAR(own, carried[i] + kLeafPipe, 1e-3 * own);
    ++forks;
  }
  EXPECT_GT(forks, 500u);
}

TEST(Grove, TrunksStandInOrdinaryYears) {
  int broken = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    GroveOptions options;
    options.years = 18;
    options.seed = Seed{seed}.child("weather");
    broken += grow_grove({seedling(Vec3(0), seed)}, options)[0].stem_broke >= 0;
  }
  EXPECT_EQ(broken, 0);
}

TEST(Grove, HurricanesAndWetSnowBreakBranches) {
  std::size_t calm = 0, wind = 0, snow = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    GroveOptions options;
    options.years = 20;
    options.wind = 5;
    calm += grow_grove({seedling(Vec3(0), seed)}, options)[0].broken;
    options.wind = 75;
    wind += grow_grove({seedling(Vec3(0), seed)}, options)[0].broken;
    options.wind = 5;
    options.snow = 60;
    snow += grow_grove({seedling(Vec3(0), seed)}, options)[0].broken;
  }
  EXPECT_LT(calm, 4u);
  EXPECT_GT(wind, 2 * calm + 8);
  EXPECT_GT(snow, 2 * calm + 8);
}

TEST(Grove, ATreeDiesOfAge) {
  GroveOptions options;
  options.years = 24;
  Seedling s = seedling(Vec3(0), 3);
  s.species.lifespan = 18;
  GrownTree t = grow_grove({s}, options)[0];
  EXPECT_EQ(living(t), 0u);
  EXPECT_GT(t.size(), 100u) << "its wood stands";
  std::size_t thin = 0;
  for (std::size_t i = 1; i < t.size(); ++i) thin += t.radius[i] < 0.003f;
  EXPECT_LT(thin, t.size() / 10) << "its twigs have fallen";
}

TEST(Grove, OddOptionsAreHarmless) {
  GroveOptions options;
  EXPECT_TRUE(grow_grove({}, options).empty());
  options.years = 0;
  EXPECT_EQ(grow_grove({seedling(Vec3(0), 1)}, options)[0].size(), 1u);
  options.years = 6;
  Seedling late = seedling(Vec3(0), 1);
  late.planted = 10;
  EXPECT_EQ(grow_grove({late}, options)[0].size(), 1u);
  options.years = 10;
  for (Sharing sharing : {Sharing::borchert_honda, Sharing::priority}) {
    for (Fading fading : {Fading::diffuse, Fading::geometric, Fading::even}) {
      Seedling s = seedling(Vec3(0), 1);
      s.species.sharing = sharing;
      options.light.fading = fading;
      options.light.base = fading == Fading::geometric ? 1.6 : 1.05;
      options.light.absorb = fading == Fading::diffuse ? 0.5 : 0.1;
      EXPECT_GT(living(grow_grove({s}, options)[0]), 40u);
    }
  }
}

}  // namespace
}  // namespace frond
