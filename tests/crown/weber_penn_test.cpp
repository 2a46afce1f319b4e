#include "crown/weber_penn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frond {
namespace {

/// A trunk of 10 m with straight level branches, nothing at random.
WeberPenn plain() {
  WeberPenn t;
  t.scale = 10;
  t.levels = 2;
  t.flare = 0;
  t.ratio = 0.02;
  t.smoothing = 1;
  t.base_size = 0.3;
  t.level[0].length = 1;
  t.level[0].curve_res = 5;
  t.level[1].branches = 14;
  t.level[1].length = 0.4;
  t.level[1].down_angle = radians(60.0);
  t.level[1].rotate = radians(140.0);
  t.level[1].curve_res = 4;
  return t;
}

/// Feet and tips of the branches of a level: chains that begin with it.
struct Branch {
  Vec3 foot, tip;
  float radius = 0, length = 0;
};
std::vector<Branch> branches(const Skeleton& s, int level) {
  std::vector<Branch> list;
  for (std::size_t i = 0; i < s.size(); ++i) {
    std::int32_t p = s.parent[i];
    if (p == Skeleton::kRoot || s.order[i] != level || s.order[p] == level) continue;
    Branch b{s.position[p], s.position[i], s.radius[i], glm::distance(s.position[p], s.position[i])};
    for (std::size_t k = i + 1;
         k < s.size() && s.parent[k] == static_cast<std::int32_t>(k) - 1 && s.order[k] == level; ++k) {
      b.length += glm::distance(s.position[k], s.position[k - 1]);
      b.tip = s.position[k];
    }
    list.push_back(b);
  }
  return list;
}

TEST(WeberPenn, TheTrunkIsAsLongAndAsThickAsTheFormulas) {
  WeberPenn t = plain();
  t.levels = 1;
  t.level[0].length = 0.8;
  t.trunk_scale = 1.5;
  Result<Crown> c = grow_weber_penn(t, Seed{1});
  ASSERT_TRUE(c.ok());
  const Skeleton& s = c->skeleton;
  EXPECT_EQ(s.find_fault(), "");
  EXPECT_EQ(s.size(), 6u);
  EXPECT_NEAR(s.position.back().y, 8, 1e-4);
  EXPECT_NEAR(s.radius.front(), 8 * 0.02 * 1.5, 1e-5);
  EXPECT_NEAR(s.radius[1], 8 * 0.02 * 1.5 * 0.8, 1e-5);  // taper 1
}

TEST(WeberPenn, BranchesAreAsManyAndAsLongAsTheFormulas) {
  WeberPenn t = plain();
  for (int shape = 0; shape <= 7; ++shape) {
    t.shape = static_cast<CrownShape>(shape);
    Result<Crown> c = grow_weber_penn(t, Seed{3});
    ASSERT_TRUE(c.ok());
    std::vector<Branch> list = branches(c->skeleton, 1);
    EXPECT_EQ(list.size(), 14u);
    for (const Branch& b : list) {
      EXPECT_GE(b.foot.y, 3 - 1e-3);
      double expected = 10 * 0.4 * shape_ratio(t.shape, (10 - b.foot.y) / 7);
      EXPECT_NEAR(b.length, expected, 1e-3) << shape;
      EXPECT_NEAR((b.tip.y - b.foot.y) / b.length, std::cos(radians(60.0)), 1e-3);
    }
  }
}

TEST(WeberPenn, RadiiFollowTheRatioPower) {
  WeberPenn t = plain();
  t.shape = CrownShape::cylindrical;
  t.ratio_power = 1.5;
  t.level[1].taper = 0;
  Result<Crown> c = grow_weber_penn(t, Seed{3});
  for (const Branch& b : branches(c->skeleton, 1)) {
    double by_length = 0.2 * std::pow(0.4, 1.5), at_foot = 0.2 * (1 - b.foot.y / 10);
    EXPECT_NEAR(b.radius, std::max(std::min(by_length, at_foot), 0.0004), 1e-4);
  }
}

TEST(WeberPenn, BranchesOfBranchesFollowThePaper) {
  WeberPenn t = plain();
  t.levels = 3;
  t.shape = CrownShape::cylindrical;
  t.level[2] = t.level[1];
  t.level[2].branches = 10;
  t.level[2].length = 0.5;
  Result<Crown> c = grow_weber_penn(t, Seed{4});
  // Every branch of the trunk is as long as it may be: 10 each; fractions are drawn by lot.
  EXPECT_EQ(branches(c->skeleton, 2).size(), 140u);
  double share = shape_ratio(CrownShape::conical, 0.5);
  EXPECT_NEAR(stem_count(t, 1, share, 0), 10 * (0.2 + 0.8 * share), 1e-9);
  EXPECT_NEAR(stem_count(t, 2, 1, 0.8), t.level[3].branches * 0.6, 1e-9);
  for (const Branch& b : branches(c->skeleton, 2)) {
    EXPECT_LE(b.length, 0.5 * 4 + 1e-3);
    EXPECT_GE(b.length, 0.5 * (4 - 0.6 * 4) - 1e-3);
  }
}

TEST(WeberPenn, ShapeRatiosAreThoseOfThePaper) {
  EXPECT_NEAR(shape_ratio(CrownShape::conical, 0.5), 0.6, 1e-12);
  EXPECT_NEAR(shape_ratio(CrownShape::spherical, 0.5), 1, 1e-12);
  EXPECT_NEAR(shape_ratio(CrownShape::hemispherical, 1), 1, 1e-12);
  EXPECT_NEAR(shape_ratio(CrownShape::cylindrical, 0.1), 1, 1e-12);
  EXPECT_NEAR(shape_ratio(CrownShape::tapered_cylindrical, 0.5), 0.75, 1e-12);
  EXPECT_NEAR(shape_ratio(CrownShape::flame, 0.7), 1, 1e-12);
  EXPECT_NEAR(shape_ratio(CrownShape::flame, 0.85), 0.5, 1e-12);
  EXPECT_NEAR(shape_ratio(CrownShape::inverse_conical, 1), 0.2, 1e-12);
  EXPECT_NEAR(shape_ratio(CrownShape::tend_flame, 0), 0.5, 1e-12);
  Pruning p{1, 0.5, 0.4, 0.7, 0.3};
  EXPECT_EQ(shape_ratio(CrownShape::envelope, -0.1, p), 0);
  EXPECT_EQ(shape_ratio(CrownShape::envelope, 1.1, p), 0);
  // Whole at the peak, from both sides.
  EXPECT_NEAR(shape_ratio(CrownShape::envelope, 0.6 - 1e-9, p), 1, 1e-6);
  EXPECT_NEAR(shape_ratio(CrownShape::envelope, 0.6 + 1e-9, p), 1, 1e-6);
  EXPECT_NEAR(shape_ratio(CrownShape::envelope, 0.3, p), std::pow(0.5, 0.3), 1e-12);
}

TEST(WeberPenn, TapersAreThoseOfThePaper) {
  EXPECT_NEAR(taper_radius(0, 1, 20, 0.5), 1, 1e-12);
  EXPECT_NEAR(taper_radius(1, 1, 20, 0.5), 0.5, 1e-12);
  EXPECT_NEAR(taper_radius(2, 1, 20, 0.5), 1, 1e-12);
  EXPECT_NEAR(taper_radius(2, 1, 20, 1), 0, 1e-9);                        // a round end
  EXPECT_NEAR(taper_radius(2, 1, 20, 0.975), std::sqrt(1 - 0.25), 1e-9);  // half a radius below it
  EXPECT_NEAR(taper_radius(3, 1, 20, 0.95), 1, 1e-9);                     // the middle of a pearl
  EXPECT_NEAR(taper_radius(3, 1, 20, 0.9), 0, 1e-6);                      // between two
  EXPECT_NEAR(flare_factor(0.5, 0), 1 + 0.5 * 0.99, 1e-12);
  EXPECT_NEAR(flare_factor(0.5, 0.125), 1, 1e-12);
}

TEST(WeberPenn, CurvesTurnByTheirAngle) {
  WeberPenn t = plain();
  t.levels = 1;
  t.level[0].curve_res = 9;
  t.level[0].curve = radians(90.0);
  auto last_slope = [&] {
    Result<Crown> c = grow_weber_penn(t, Seed{1});
    const auto& p = c->skeleton.position;
    return degrees(std::acos(glm::normalize(p.back() - p[p.size() - 2]).y));
  };
  EXPECT_NEAR(last_slope(), 90, 0.1);
  t.level[0].curve_res = 10;
  t.level[0].curve = radians(60.0);
  t.level[0].curve_back = radians(-60.0);
  EXPECT_NEAR(last_slope(), 0, 0.5);
  t.level[0].curve = t.level[0].curve_back = 0;
  t.level[0].curve_v = radians(-25.0);  // a helix keeps its slope
  EXPECT_NEAR(last_slope(), 25, 0.2);
}

TEST(WeberPenn, SplitsMakeClones) {
  WeberPenn t = plain();
  t.levels = 1;
  t.base_splits = 2;
  t.level[0].split_angle = radians(30.0);
  Result<Crown> c = grow_weber_penn(t, Seed{1});
  EXPECT_EQ(c->skeleton.find_fault(), "");
  EXPECT_EQ(c->skeleton.size(), 6u + 2 * 4);  // two clones of four segments
  t.base_splits = 0;
  t.level[0].seg_splits = 1;
  c = grow_weber_penn(t, Seed{1});
  EXPECT_EQ(c->skeleton.size(), 1u + 1 + 2 + 4 + 8 + 16);  // doubled at each segment's end
}

TEST(WeberPenn, AStemAndItsClonesShareWhatItWouldBear) {
  WeberPenn t = plain();
  t.level[1].branches = 120;
  t.level[0].split_angle = radians(20.0);
  t.base_size = 0;
  for (int clones : {0, 1, 3, 7}) {
    t.base_splits = clones;
    EXPECT_NEAR(static_cast<double>(branches(grow_weber_penn(t, Seed{2})->skeleton, 1).size()), 120,
                clones + 1)
        << clones;
  }
  // As dense over the foot as ever, over the split a share on each.
  t.base_splits = 3;
  t.level[0].split_angle = 0;
  double low = 0, high = 0;
  for (const Branch& b : branches(grow_weber_penn(t, Seed{2})->skeleton, 1)) (b.foot.y < 2 ? low : high) += 1;
  EXPECT_NEAR(low, 24, 1);
  EXPECT_NEAR(high, 96, 4);
  // Splits of single segments, too.
  t.base_splits = 0;
  t.level[0].seg_splits = 0.5;
  EXPECT_NEAR(static_cast<double>(branches(grow_weber_penn(t, Seed{2})->skeleton, 1).size()), 120, 6);
}

TEST(WeberPenn, PartsOfSplitsCountOnFromStemToStem) {
  WeberPenn t = plain();
  t.level[1].branches = 40;
  t.level[1].curve_res = 2;
  t.level[1].seg_splits = 0.2;
  t.level[1].split_angle = radians(30.0);
  // Each branch asks at the end of its first segment; whatever the seed, every fifth of them splits.
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Skeleton s = grow_weber_penn(t, Seed{seed})->skeleton;
    EXPECT_EQ(std::count(s.order.begin(), s.order.end(), 1), 40 * 2 + 8) << seed;
  }
}

TEST(WeberPenn, APrunedBranchBearsNoMoreThanItsLengthAllows) {
  WeberPenn t = plain();
  t.levels = 3;
  t.shape = CrownShape::cylindrical;
  t.level[1].down_angle = radians(90.0);
  t.level[2] = t.level[1];
  t.level[2].branches = 50;
  t.level[2].length = 0.02;
  std::size_t whole = branches(grow_weber_penn(t, Seed{6})->skeleton, 2).size();
  t.pruning = {1, 0.2, 0.5, 0.01, 0.01};  // to half their length
  std::size_t pruned = branches(grow_weber_penn(t, Seed{6})->skeleton, 2).size();
  EXPECT_NEAR(static_cast<double>(pruned) / static_cast<double>(whole), 0.2 + 0.8 * 0.5, 0.08);
}

TEST(WeberPenn, PruningKeepsBranchesInTheEnvelope) {
  WeberPenn t = plain();
  t.shape = CrownShape::cylindrical;
  t.level[1].branches = 60;
  t.level[1].length = 0.9;
  t.pruning = {1, 0.3, 0.5, 0.5, 0.5};
  Result<Crown> c = grow_weber_penn(t, Seed{8});
  const Skeleton& s = c->skeleton;
  int cut = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.order[i] != 1) continue;
    Vec3 p = s.position[i];
    double most = 10 * 0.3 * shape_ratio(CrownShape::envelope, (10 - p.y) / 7, t.pruning);
    EXPECT_LE(std::hypot(p.x, p.z), most + 1e-3);
    ++cut;
  }
  EXPECT_GT(cut, 100);
  t.pruning.ratio = 0;
  double widest = 0;
  c = grow_weber_penn(t, Seed{8});
  for (Vec3 p : c->skeleton.position) widest = std::max<double>(widest, std::hypot(p.x, p.z));
  EXPECT_GT(widest, 6);
}

TEST(WeberPenn, AttractionLiftsOrLowersFromTheSecondLevel) {
  WeberPenn t = plain();
  t.levels = 3;
  t.level[2] = t.level[1];
  t.level[2].branches = 8;
  t.level[2].length = 0.6;
  auto mean = [&](double up) {
    t.attraction_up = up;
    Result<Crown> c = grow_weber_penn(t, Seed{5});
    double sum = 0;
    for (const Branch& b : branches(c->skeleton, 2)) sum += (b.tip.y - b.foot.y) / b.length;
    return sum;
  };
  double none = mean(0), up = mean(0.8), down = mean(-0.8);
  EXPECT_GT(up, none);
  EXPECT_LT(down, none);
}

TEST(WeberPenn, LeavesStandOnTheLastLevel) {
  WeberPenn t = plain();
  t.leaves = 12;
  t.leaf_distribution = CrownShape::cylindrical;
  t.level[2].down_angle = radians(45.0);
  t.level[2].rotate = radians(137.0);
  t.leaf_bend = 0;
  Result<Crown> c = grow_weber_penn(t, Seed{2});
  EXPECT_EQ(c->leaves.size(), 14u * 12);
  for (const LeafSite& leaf : c->leaves) {
    EXPECT_EQ(c->skeleton.order[leaf.node], 1);
    EXPECT_NEAR(glm::length(leaf.turn), 1, 1e-4);
    EXPECT_LT(glm::distance(leaf.position, c->skeleton.position[leaf.node]), 1.1f);
  }
  // With LeafBend they turn their faces to the light.
  auto lit = [&](double bend) {
    t.leaf_bend = bend;
    double sum = 0;
    Result<Crown> grown = grow_weber_penn(t, Seed{2});
    for (const LeafSite& leaf : grown->leaves) sum += (leaf.turn * Vec3(0, 0, 1)).y;
    return sum;
  };
  EXPECT_GT(lit(0.7), lit(0) + 20);
  t.leaves = -5;
  EXPECT_EQ(grow_weber_penn(t, Seed{2})->leaves.size(), 14u * 5);
}

TEST(WeberPenn, AngleOfLeavesFallsTowardTheTipWhereItsVariationIsNegative) {
  WeberPenn t = plain();
  t.leaves = 12;
  t.leaf_bend = 0;
  t.leaf_distribution = CrownShape::cylindrical;
  t.level[2].down_angle = radians(50.0);
  t.level[2].down_angle_v = radians(-40.0);
  t.level[2].rotate = radians(140.0);
  Result<Crown> c = grow_weber_penn(t, Seed{2});
  Vec3 along(0);
  for (std::size_t i = 0; i < c->leaves.size(); ++i) {
    if (i % 12 == 0) along = glm::normalize(c->leaves[i + 11].position - c->leaves[i].position);
    double angle = std::acos(glm::dot(c->leaves[i].turn * Vec3(0, 1, 0), along));
    double ratio = 1 - (static_cast<double>(i % 12) + 0.5) / 12;
    EXPECT_NEAR(degrees(angle), 50 - 40 * (1 - 2 * (0.2 + 0.8 * ratio)), 3);
  }
}

TEST(WeberPenn, TooManyLeavesAreRefused) {
  WeberPenn t = plain();
  t.leaf_distribution = CrownShape::cylindrical;
  t.leaves = 2e7;
  Result<Crown> c = grow_weber_penn(t, Seed{2});
  ASSERT_FALSE(c.ok());
  EXPECT_NE(c.errors()[0].what.find("leaves"), std::string::npos);
}

TEST(WeberPenn, TheSameSeedIsTheSameTree) {
  WeberPenn t = plain();
  t.scale_v = 2;
  t.level[0].curve_v = t.level[1].curve_v = radians(60.0);
  Result<Crown> a = grow_weber_penn(t, Seed{9}), b = grow_weber_penn(t, Seed{9}),
                d = grow_weber_penn(t, Seed{10});
  EXPECT_EQ(a->skeleton.position, b->skeleton.position);
  EXPECT_NE(a->skeleton.position, d->skeleton.position);
}

TEST(WeberPenn, RunawaySplitsAreRefused) {
  WeberPenn split = plain();
  split.levels = 1;
  split.level[0].curve_res = 100000;
  split.level[0].seg_splits = 1;
  EXPECT_FALSE(grow_weber_penn(split, Seed{1}).ok());
  WeberPenn t = plain();
  t.levels = 4;
  t.level[1].branches = 400;
  t.level[2] = t.level[3] = t.level[1];
  t.level[3].branches = 400;
  t.shape = CrownShape::cylindrical;
  EXPECT_FALSE(grow_weber_penn(t, Seed{1}).ok());
  EXPECT_GT(estimate_nodes(t), 4e6);
}

TEST(WeberPenn, CurvesAlongTheParentShapeWhatItBears) {
  WeberPenn t = plain();
  t.shape = CrownShape::cylindrical;
  t.level[1].branches = 40;
  auto grown = [](const WeberPenn& tree) {
    Result<Crown> crown = grow_weber_penn(tree, Seed{3});
    EXPECT_TRUE(crown.ok());
    return crown ? branches(crown->skeleton, 1) : std::vector<Branch>{};
  };
  const std::vector<Branch> even = grown(t);
  // The number stays, and most stand where the curve is high: nothing below half of the trunk.
  WeberPenn dense = t;
  dense.level[1].branches_along = Curve({{0, 0}, {0.5, 0}, {0.6, 1}, {1, 1}});
  const std::vector<Branch> high = grown(dense);
  EXPECT_EQ(high.size(), even.size());
  for (const Branch& b : high) EXPECT_GT(b.foot.y, 5);
  dense.level[1].branches_along = Curve({{0, 0}, {1, 0}});
  EXPECT_TRUE(grown(dense).empty());
  // A density that is the same everywhere, whatever it is, changes nothing to speak of.
  dense.level[1].branches_along = Curve({{0, 3}, {1, 3}});
  const std::vector<Branch> thrice = grown(dense);
  ASSERT_EQ(thrice.size(), even.size());
  for (std::size_t i = 0; i < even.size(); ++i) EXPECT_NEAR(thrice[i].foot.y, even[i].foot.y, 0.01);

  WeberPenn shaped = t;
  shaped.level[1].length_along = Curve({{0, 1}, {1, 0.5}});
  shaped.level[1].angle_along = Curve({{0, 1.5}, {1, 0.5}});
  const std::vector<Branch> list = grown(shaped);
  ASSERT_EQ(list.size(), even.size());
  for (const Branch& b : list) {
    const double place = b.foot.y / 10;
    EXPECT_NEAR(b.length, 4 * (1 - 0.5 * place), 0.01) << place;
    EXPECT_NEAR((b.tip.y - b.foot.y) / b.length, std::cos(radians(60.0) * (1.5 - place)), 0.01) << place;
  }
  WeberPenn thin = t;
  thin.level[1].radius_along = Curve({{0, 0.5}, {1, 0.5}});
  const std::vector<Branch> half = grown(thin);
  ASSERT_EQ(half.size(), even.size());
  for (std::size_t i = 0; i < even.size(); ++i) EXPECT_LE(half[i].radius, even[i].radius);
  // Near the tip of the trunk they are no thicker than that in any case; the lowest shows the factor.
  const auto lowest = [](const std::vector<Branch>& all) {
    return *std::ranges::min_element(all, {}, [](const Branch& branch) { return branch.foot.y; });
  };
  EXPECT_NEAR(lowest(half).radius, lowest(even).radius / 2, 1e-5);
}

}  // namespace
}  // namespace frond
