#include "grove/edit_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "grove/axes.h"

namespace frond {
namespace {

GrownTree grown_with(int years, std::vector<YearCut> cuts = {}, bool history = true) {
  Species species;
  species.clear_trunk = 0;
  Seedling seedling{species, Vec3(0), Vec3(0, 1, 0), Seed{4}, 0, {}, "", std::move(cuts)};
  GroveOptions options;
  options.years = years, options.wind = 0, options.history = history;
  return grow_grove({seedling}, options)[0];
}

/// The address of the thickest limb that stands on the stem at the end of a tree's life.
Address thickest_limb(const GrownTree& t) {
  std::vector<AxisNode> axes = axis_nodes(t);
  Branching plant{t.parent, axes};
  std::int32_t best = -1;
  for (std::size_t i = 1; i < t.size(); ++i)
    if (t.order[i] == 1 && t.order[t.parent[i]] == 0 && t.fell[i] == GrownTree::kNever &&
        (best < 0 || t.radius[i] > t.radius[best]))
      best = static_cast<std::int32_t>(i);
  return *address_of(plant, {best, 0});
}

Vec3 first_tip(const GrownTree& t, const Address& at) {
  std::vector<AxisNode> axes = axis_nodes(t);
  Branching plant{t.parent, axes};
  Result<BranchPlace> place = find_place(plant, axis_starts(plant), at);
  EXPECT_TRUE(place) << text(at);
  return place ? t.tip[place->node] : Vec3(0);
}

TEST(EditTree, AddressesHoldThroughTheYears) {
  GrownTree young = grown_with(8), old = grown_with(12), still = grown_with(12, {}, false);
  Address limb = thickest_limb(old);
  EXPECT_EQ(first_tip(young, limb), first_tip(old, limb));
  EXPECT_EQ(first_tip(still, limb), first_tip(old, limb));
}

TEST(EditTree, ACutInAYearChangesNothingBefore) {
  GrownTree plain = grown_with(13);
  Address limb = thickest_limb(plain);
  GrownTree cut = grown_with(13, {{8, limb, 0}});
  EXPECT_TRUE(cut.notes.empty());
  for (std::size_t year = 0; year < 8; ++year)
    EXPECT_EQ(plain.sizes[year].internodes, cut.sizes[year].internodes) << year;
  EXPECT_LT(cut.sizes[8].internodes, plain.sizes[8].internodes);
  // All that was born by then is the same.
  std::size_t same = 0;
  for (std::size_t i = 0; i < cut.size() && cut.born[i] <= 9; ++i, ++same)
    EXPECT_EQ(cut.tip[i], plain.tip[i]);
  EXPECT_GT(same, 100u);
  // And nothing of the limb stands afterwards.
  std::vector<AxisNode> axes = axis_nodes(cut);
  Branching plant{cut.parent, axes};
  BranchPlace place = *find_place(plant, axis_starts(plant), limb);
  EXPECT_EQ(cut.fell[place.node], 9);
}

TEST(EditTree, ATreeAnswersACutByNewShoots) {
  for (bool stem : {false, true}) {
    GrownTree plain = grown_with(10);
    Address at = stem ? *parse_address(":0.4") : thickest_limb(plain);
    if (!stem) at.share = 0.3;
    GrownTree cut = grown_with(14, {{9, at, 0}}), again = grown_with(14, {{9, at, 0}});
    EXPECT_EQ(cut.tip, again.tip);
    ASSERT_EQ(cut.cuts.size(), 1u);
    EXPECT_EQ(cut.cuts[0].time, 10);
    // Below the cut, on the axis that was cut, shoots begin in the years after.
    std::size_t shoots = 0;
    const std::uint16_t order = cut.order[cut.cuts[0].on];
    for (std::size_t i = 1; i < cut.size(); ++i) {
      if (cut.born[i] <= 10 || cut.order[i] != order + 1) continue;
      std::int32_t node = static_cast<std::int32_t>(cut.cuts[0].on);
      for (int k = 0; k < 6 && node > 0; ++k, node = cut.parent[node])
        if (cut.parent[i] == node) ++shoots;
    }
    EXPECT_GT(shoots, 0u) << stem;
  }
}

TEST(EditTree, NewBudsComeWhereNoneIsAlive) {
  GrownTree plain = grown_with(10);
  Address limb = thickest_limb(plain);
  GrownTree cut = grown_with(14, {{9, limb, 0}});
  std::vector<AxisNode> axes = axis_nodes(cut);
  for (std::uint32_t i : cut.regrown) EXPECT_GT(axes[i].number, kRegrown);
  for (std::size_t i = 0; i < cut.size(); ++i)
    if (axes[i].number > kRegrown) {
      EXPECT_TRUE(std::ranges::binary_search(cut.regrown, static_cast<std::uint32_t>(i)));
    }
}

TEST(EditTree, CutsThatFindNothingAreNoted) {
  GrownTree tree = grown_with(6, {{3, *parse_address("500"), 2}});
  ASSERT_EQ(tree.notes.size(), 1u);
  EXPECT_TRUE(tree.notes[0].starts_with("/edits/2/at: finds no branch: the stem has "));
  EXPECT_EQ(tree.tip, grown_with(6).tip);
}

TEST(EditTree, EditsOfAllYearsKeepTheHistoryWhole) {
  GrownTree plain = grown_with(11), cut = plain, bent = plain;
  Address limb = thickest_limb(plain);
  edit_tree(cut, std::vector{Edit{.at = limb, .cut = 0}});
  EXPECT_LT(cut.size(), plain.size());
  EXPECT_EQ(cut.first_ring.size(), cut.size() + 1);
  EXPECT_EQ(cut.first_ring.back(), cut.ring.size());
  for (std::size_t i = 1; i < cut.size(); ++i) ASSERT_LT(cut.parent[i], static_cast<std::int32_t>(i));
  limb.share = 0.8;
  edit_tree(bent, std::vector{Edit{.at = limb, .bend = Vec3(0, -0.2f, 0.1f)}});
  ASSERT_EQ(bent.size(), plain.size());
  EXPECT_NE(bent.tip, plain.tip);
  for (std::size_t i = 1; i < bent.size(); ++i)
    EXPECT_NEAR(glm::distance(bent.tip[i], bent.tip[bent.parent[i]]),
                glm::distance(plain.tip[i], plain.tip[plain.parent[i]]), 1e-4f);
}

}  // namespace
}  // namespace frond
