#include "images/venation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "images/leaf_blade.h"

namespace frond {
namespace {

constexpr double kFinest = 0.022;

std::vector<std::pair<std::string, LeafOutline>> outlines() {
  std::vector<std::pair<std::string, LeafOutline>> list;
  for (std::string_view name : leaf_names()) list.emplace_back(name, leaf_outline(name));
  for (auto [name, pattern] : {std::pair{"tulip", VeinPattern::parallel}, {"grass", VeinPattern::parallel}}) {
    LeafOutline o = leaf_outline(name == std::string_view("tulip") ? "beech" : "willow");
    o.venation = {pattern, 6};
    list.emplace_back(name, o);
  }
  return list;
}

TEST(Venation, EveryVeinLiesInTheBlade) {
  for (const auto& [name, outline] : outlines()) {
    Lamina blade(outline);
    Veins veins = grow_veins(outline, kFinest, Seed{1});
    ASSERT_GT(veins.size(), 100u) << name;
    EXPECT_EQ(veins.point[0], blade.foot()) << name;
    for (std::size_t i = 1; i < veins.size(); ++i) {
      ASSERT_GE(veins.parent[i], 0);
      ASSERT_LT(veins.parent[i], static_cast<int>(i)) << name;
      ASSERT_LT(blade.out(veins.point[i]), 1) << name << " " << veins.point[i].x << " " << veins.point[i].y;
    }
  }
}

TEST(Venation, WidthsFollowThePipeModel) {
  for (const auto& [name, outline] : outlines()) {
    Veins veins = grow_veins(outline, kFinest, Seed{1});
    std::vector<double> fed(veins.size(), 0);
    auto cube = [&](std::size_t i) { return std::pow(static_cast<double>(veins.width[i]), 3); };
    for (std::size_t i = 1; i < veins.size(); ++i) fed[veins.parent[i]] += cube(i);
    float finest = *std::ranges::min_element(veins.width);
    for (std::size_t i = 0; i < veins.size(); ++i) {
      if (fed[i] > 0) {
        ASSERT_NEAR(cube(i) / fed[i], 1, 1e-3) << name << i;
      } else {
        ASSERT_NEAR(veins.width[i] / finest, 1, 1e-3) << name << i;  // ends are equally wide
      }
    }
    EXPECT_GT(veins.width[0], 2.5 * finest) << name;
  }
}

TEST(Venation, NoPlaceOfABladeIsFarFromAVein) {
  for (const auto& [name, outline] : outlines()) {
    Lamina blade(outline);
    Veins veins = grow_veins(outline, kFinest, Seed{1});
    double farthest = 0;
    for (float y = blade.low(); y < blade.high(); y += 0.03f)
      for (float x = -blade.wide(); x < blade.wide(); x += 0.03f) {
        if (!blade.holds({x, y}, 0.06)) continue;
        float nearest = 1;
        for (Vec2 p : veins.point) nearest = std::min(nearest, glm::distance(p, Vec2(x, y)));
        farthest = std::max<double>(farthest, nearest);
      }
    EXPECT_LT(farthest, name == "ginkgo" ? 0.08 : 0.04) << name;
  }
}

TEST(Venation, IsTheSameForTheSameSeed) {
  LeafOutline oak = leaf_outline("oak");
  Veins a = grow_veins(oak, kFinest, Seed{1}), b = grow_veins(oak, kFinest, Seed{1}),
        c = grow_veins(oak, kFinest, Seed{2});
  EXPECT_EQ(a.point, b.point);
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.joins, b.joins);
  EXPECT_NE(a.point, c.point);
  // But the larger veins, along which meshes are folded, lie alike in all.
  for (std::size_t i = 0; i < a.size() && a.order[i] < 3; ++i) EXPECT_EQ(a.point[i], c.point[i]);
}

TEST(Venation, OnlyClosedPatternsHaveLoops) {
  for (auto [name, outline] : outlines()) {
    const bool fan = outline.venation.pattern == VeinPattern::dichotomous;
    outline.venation.loops = true;
    Veins closed = grow_veins(outline, kFinest, Seed{1});
    if (fan) {
      EXPECT_TRUE(closed.joins.empty()) << name;
    } else {
      EXPECT_GT(closed.joins.size(), 20u) << name;
    }
    // All points hang together by their parents, so each join closes a loop unless it doubles a vein.
    for (auto [a, b] : closed.joins) {
      EXPECT_NE(closed.parent[a], static_cast<int>(b)) << name;
      EXPECT_NE(closed.parent[b], static_cast<int>(a)) << name;
      EXPECT_LT(glm::distance(closed.point[a], closed.point[b]), 0.05f) << name;
    }
    outline.venation.loops = false;
    EXPECT_TRUE(grow_veins(outline, kFinest, Seed{1}).joins.empty()) << name;
  }
}

TEST(Venation, LobesAndTeethAreWhereVeinsEnd) {
  auto reached = [](const Veins& veins, Vec2 tip) {
    float nearest = 1;
    for (std::size_t i = 0; i < veins.size(); ++i)
      if (veins.order[i] <= 2) nearest = std::min(nearest, glm::distance(veins.point[i], tip));
    return nearest;
  };
  for (std::string_view name : {"oak", "maple", "ivy"}) {
    LeafOutline outline = leaf_outline(name);
    Lamina blade(outline);
    Veins veins = grow_veins(outline, 0.1, Seed{1});
    std::vector<RimTip> lobes = rim_tips(outline, 0.09);
    EXPECT_GE(lobes.size(), 2u) << name;
    for (const RimTip& lobe : lobes)
      for (int side : {1, -1})
        EXPECT_LT(reached(veins, blade.at(side * lobe.angle)), 0.03f) << name << lobe.angle;
  }
  // Of a toothed leaf all secondaries end in teeth, save the shortest.
  LeafOutline birch = leaf_outline("birch");
  Lamina blade(birch);
  std::vector<RimTip> teeth = rim_tips(birch, 0.005);
  EXPECT_GE(teeth.size(), 15u);
  int in_teeth = 0, all = 0;
  for (const SecondaryLine& line : secondary_lines(birch)) {
    float nearest = 1;
    for (const RimTip& tooth : teeth)
      for (int side : {1, -1})
        nearest = std::min(nearest, glm::distance(line.to, blade.at(side * tooth.angle)));
    in_teeth += nearest < 0.02f, ++all;
  }
  EXPECT_GE(all, 10);
  EXPECT_GE(in_teeth, all - 3);
}

TEST(Venation, PalmateVeinsLeaveTheFoot) {
  Veins veins = grow_veins(leaf_outline("maple"), 0.1, Seed{1});
  int leave = 0;
  for (std::size_t i = 1; i < veins.size(); ++i) leave += veins.order[i] == 1 && veins.parent[i] == 0;
  EXPECT_EQ(leave, 5);
}

TEST(Venation, ParallelVeinsRunSideBySide) {
  LeafOutline outline = leaf_outline("beech");
  outline.venation = {VeinPattern::parallel, 6};
  Veins veins = grow_veins(outline, 0.1, Seed{1});
  for (float y : {0.4f, 0.55f, 0.7f}) {
    std::vector<float> crossed;
    for (std::size_t i = 1; i < veins.size(); ++i) {
      Vec2 a = veins.point[veins.parent[i]], b = veins.point[i];
      if (veins.order[i] == 1 && a.y < y && b.y >= y)
        crossed.push_back(std::lerp(a.x, b.x, (y - a.y) / (b.y - a.y)));
    }
    EXPECT_EQ(crossed.size(), 13u) << y;
    std::ranges::sort(crossed);
    for (std::size_t i = 1; i < crossed.size(); ++i) EXPECT_GT(crossed[i] - crossed[i - 1], 0.01f) << y;
  }
}

TEST(Venation, AFanForksInTwoAgainAndAgain) {
  Veins veins = grow_veins(leaf_outline("ginkgo"), kFinest, Seed{1});
  std::vector<int> children(veins.size(), 0);
  for (std::size_t i = 1; i < veins.size(); ++i) ++children[veins.parent[i]];
  int forks = 0, most = 0;
  for (int n : children) forks += n == 2, most = std::max(most, n);
  EXPECT_EQ(most, 2);
  EXPECT_GT(forks, 12);
}

TEST(Venation, NothingFinerIsGrownThanAsked) {
  LeafOutline outline = leaf_outline("linden");
  Veins fine = grow_veins(outline, 0.02, Seed{1}), coarse = grow_veins(outline, 0.06, Seed{1});
  EXPECT_GT(fine.size(), 2 * coarse.size());
  EXPECT_LT(*std::ranges::max_element(coarse.order), *std::ranges::max_element(fine.order));
}

TEST(Venation, ADenserNetHasMoreVeins) {
  LeafOutline outline = leaf_outline("linden");
  std::size_t before = 0;
  for (double density : {0.5, 1.0, 1.05, 1.5, 2.0, 3.0}) {
    outline.venation.density = density;
    // As finely as a large picture has it.
    std::size_t now = grow_veins(outline, 0.022 / std::max(1.0, density), Seed{1}).size();
    EXPECT_GT(now, before) << density;
    before = now;
  }
  // At one limit nets are the same but for chance, never a round less.
  outline.venation.density = 1;
  before = grow_veins(outline, 0.03, Seed{1}).size();
  outline.venation.density = 3;
  EXPECT_GT(static_cast<double>(grow_veins(outline, 0.03, Seed{1}).size()),
            0.8 * static_cast<double>(before));
}

TEST(Venation, OfNarrowBladesAreAsManyAsHaveRoom) {
  LeafOutline outline = leaf_outline("willow");
  outline.venation = {VeinPattern::parallel, 60};
  Veins veins = grow_veins(outline, 0.022, Seed{1});
  EXPECT_GT(std::ranges::count(veins.order, 1), 200);
}

TEST(Venation, OutlinesOfAnySizeAreTheSameBlade) {
  LeafOutline one = leaf_outline("oak"), large = one;
  one.radii = {0.1, 0.4, 0.7, 0.8, 0.6, 0.3, 0.1};
  large.radii = {10, 40, 70, 80, 60, 30, 10};
  EXPECT_NEAR(Lamina(one).wide(), Lamina(large).wide(), 1e-3);
  EXPECT_LT(Lamina(large).wide(), 40);
  const auto few = static_cast<double>(grow_veins(one, 0.03, Seed{1}).size());
  EXPECT_NEAR(static_cast<double>(grow_veins(large, 0.03, Seed{1}).size()), few, 0.05 * few);
}

}  // namespace
}  // namespace frond
