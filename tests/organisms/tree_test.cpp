#include "organisms/tree/tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/tubes.h"
#include "organisms/tree/knots.h"

namespace frond {
namespace {

TreeParams sapling() {
  TreeParams params;
  params.years = 12;
  return params;
}

TEST(Tree, IsAWholeModel) {
  Model model = grow_tree(sapling(), Seed{3});
  EXPECT_EQ(model.find_fault(), "");
  EXPECT_GT(model.skeleton.size(), 300u);
  EXPECT_GT(model.organs.size(), 100u);
  EXPECT_EQ(model.skeleton.parent[0], Skeleton::kRoot);
  EXPECT_EQ(model.skeleton.position[0], Vec3(0));
}

TEST(Tree, StandsOnAFlaredFootWithRoots) {
  TreeParams params = sapling(), plain = params;
  plain.flare = 0, plain.roots = 0;
  Model with = grow_tree(params, Seed{3}), without = grow_tree(plain, Seed{3});
  EXPECT_NEAR(with.skeleton.radius[0], 1.7f * without.skeleton.radius[0], 1e-3f);
  EXPECT_EQ(with.skeleton.size(), without.skeleton.size() + 25);
  auto lowest = [](const Skeleton& s) {
    return std::min_element(s.position.begin(), s.position.end(), [](Vec3 a, Vec3 b) { return a.y < b.y; })
        ->y;
  };
  EXPECT_LT(lowest(with.skeleton), 0) << "roots go into the ground";
}

TEST(Tree, LeavesRideOnYoungShoots) {
  TreeParams params = sapling();
  params.species.leaf_years = 1;
  Model young = grow_tree(params, Seed{3});
  for (std::size_t i = 0; i < young.organs.size(); ++i) {
    std::int32_t node = young.organs.node[i];
    EXPECT_LT(glm::distance(young.organs.position[i], young.skeleton.position[node]), 1e-5f);
    EXPECT_LT(young.skeleton.radius[node], 0.012f);
  }
  params.leaves.size = 0;
  EXPECT_EQ(grow_tree(params, Seed{3}).organs.size(), 0u);
}

TEST(Tree, StemsFollowTheirGuideAndGoOnPastItsEnd) {
  TreeParams params = sapling();
  params.years = 22;
  for (Vec3 at : {Vec3(0.2f, 0.8f, 0), Vec3(0.8f, 1.5f, 0), Vec3(1.6f, 1.8f, 0.3f), Vec3(2.2f, 2.6f, 0.8f)}) {
    GuidePoint point;
    point.at = DVec3(at);
    point.parent = static_cast<std::int32_t>(params.guide.points.size()) - 1;
    params.guide.points.push_back(point);
  }
  GuideAxis line = axes_of(*axes_of_guide(params.guide))[0];
  for (std::uint64_t seed : {1u, 2u, 3u}) {
    Vec3 foot(5, 1, -2);
    Grove grove =
        grow_trees(std::vector<TreeSite>{{&params, foot, Quat(1, 0, 0, 0), 1, Seed{seed}}}, false, Seed{9});
    const GrownTree& tree = grove.trees[0];
    double farthest = 0, reached = 1e9, free = 0;
    std::size_t off = 0;
    for (std::size_t i = 1; i < tree.size(); ++i) {
      if (tree.order[i] != 0) {
        ++off;
        continue;
      }
      double away = 1e9, along = 0;
      for (int k = 0; k <= 200; ++k) {
        double far = glm::distance(line.point(line.length() * k / 200), tree.tip[i] - foot);
        if (far < away) away = far, along = line.length() * k / 200;
      }
      // What has come past the end of the guide is free.
      if (along < 0.99 * line.length())
        farthest = std::max(farthest, away);
      else
        free = std::max(free, away);
      reached = std::min<double>(reached, glm::distance(line.at.back(), tree.tip[i] - foot));
    }
    EXPECT_LT(farthest, 0.04 * line.length()) << "seed " << seed;
    EXPECT_LT(reached, 0.1 * line.length()) << "it comes to the guide's end";
    EXPECT_GT(free, 0.2) << "and grows on";
    EXPECT_GT(off, 200u) << "branches are its own";
  }
}

TEST(Tree, HangingSprigsHang) {
  auto pointing = [](double hang) {
    TreeParams params = sapling();
    params.leaves.hang = hang;
    Model model = grow_tree(params, Seed{3});
    double sum = 0;
    for (const Quat& turn : model.organs.turn) sum += (turn * Vec3(0, 1, 0)).y;
    return sum / static_cast<double>(model.organs.size());
  };
  EXPECT_GT(pointing(0), 0.2);
  EXPECT_LT(pointing(1), -0.9);
}

TEST(Tree, YearsFollowTheFilm) {
  Growth growth{2, 10, 0, 0.3};
  EXPECT_EQ(cycle_at(growth, 20, 0), 0);
  EXPECT_NEAR(cycle_at(growth, 20, 7), 10.25, 1e-9);
  EXPECT_NEAR(cycle_at(growth, 20, 99), 20.5, 1e-9);
  EXPECT_NEAR(cycle_at({}, 20, 0), 20.5, 1e-9);
}

TEST(Tree, YoungerOnesBeginLater) {
  TreeParams params = sapling();
  std::vector<TreeSite> sites(2);
  for (TreeSite& site : sites) site.params = &params;
  sites[1].foot = Vec3(30, 0, 0);
  sites[1].age = 0.5;
  Grove grove = grow_trees(sites, true, Seed{1});
  EXPECT_EQ(grove.cycles, 12);
  EXPECT_EQ(grove.trees[1].born[0], 6);
  EXPECT_LT(grove.trees[1].size(), grove.trees[0].size() / 2);
  Model early = tree_model(params, grove.trees[1], 5, {}, Seed{1});
  EXPECT_LT(early.skeleton.size(), 2u) << "it has not come up yet";
}

TEST(Tree, EveryMomentIsAWholeModel) {
  TreeParams params = sapling();
  TreeSite site{&params, Vec3(1, 0, 2), Quat(1, 0, 0, 0), 1, Seed{5}};
  Grove grove = grow_trees({&site, 1}, true, Seed{1});
  std::size_t last = 0;
  for (double year : {0.0, 0.01, 0.5, 1.0, 3.3, 7.99, 8.0, 11.2, 12.5}) {
    Model model = tree_model(params, grove.trees[0], year, {0.4, 1}, Seed{2});
    EXPECT_EQ(model.find_fault(), "") << "year " << year;
    EXPECT_GE(model.skeleton.size() + 50, last);
    last = model.skeleton.size();
  }
}

/// A stem five metres high that bore a bough at three of them until year 10, and is so thick by then.
struct Pruned {
  GrownTree tree;
  Skeleton skeleton;
  Standing now;
  std::vector<std::int32_t> node;

  explicit Pruned(float radius) {
    for (int i = 0; i < 6; ++i) {
      tree.tip.emplace_back(0, i, 0);
      tree.parent.push_back(i - 1);
      now.source.push_back(static_cast<std::uint32_t>(i));
      now.tip.push_back(tree.tip.back());
      now.foot.push_back(tree.tip[static_cast<std::size_t>(std::max(0, i - 1))]);
      now.parent.push_back(i - 1);
      node.push_back(skeleton.add(tree.tip.back(), radius, i - 1, 0));
    }
    tree.scars.push_back({3, glm::normalize(Vec3(1, 1, 0)), 0.03f, 0.1f, 10, 77});
  }

  std::vector<Knot> knots(double year, double length = 1) {
    return add_knots(skeleton, now, tree, node, length, year, Seed{4});
  }
  /// How far it stands out of the bark.
  float out() const { return (skeleton.position.back().x + skeleton.radius.back()) - skeleton.radius[3]; }
};

TEST(Tree, StubsOfFallenBoughsAreGrownOver) {
  EXPECT_TRUE(Pruned(0.1f).knots(9.9).empty()) << "it has not fallen yet";
  EXPECT_TRUE(Pruned(0.1f).knots(12, 0).empty()) << "none are asked for";
  Pruned fresh(0.1f), old(0.1f), thick(0.13f), closed(0.2f), gone(0.5f);
  float wound = fresh.knots(10.1).at(0).wound;
  EXPECT_GT(wound, 0.02f);
  EXPECT_EQ(fresh.skeleton.size(), 8u);
  EXPECT_EQ(old.knots(40).at(0).wound, wound);
  EXPECT_LT(old.out(), fresh.out()) << "it rots back";
  EXPECT_GT(old.out(), 0);
  EXPECT_LT(thick.knots(40).at(0).wound, wound) << "bark grows over it";
  EXPECT_EQ(closed.knots(40).at(0).wound, 0);
  EXPECT_LT(closed.out(), old.out());
  EXPECT_TRUE(gone.knots(40).empty());
}

TEST(Tree, StubsGoWithoutAJump) {
  float last = 0, wound = 0;
  for (int k = 0; k <= 400; ++k) {
    Pruned stem(0.1f + 0.001f * static_cast<float>(k));
    std::vector<Knot> knots = stem.knots(10 + 0.1 * k);
    if (knots.empty()) {
      EXPECT_LT(last, 0.01f) << "it had sunk by then";
      return;
    }
    if (k > 0) {
      ASSERT_NEAR(stem.out(), last, 0.004f) << k;
      ASSERT_NEAR(knots[0].wound, wound, 0.002f) << k;
    }
    last = stem.out(), wound = knots[0].wound;
  }
  FAIL() << "it was never grown over";
}

TEST(Tree, BareWoodStandsAtTheEndsOfStubs) {
  TreeParams params = sapling();
  params.years = 40, params.species.clear_trunk = 8;
  TreeParams plain = params;
  plain.knots = 0;
  Model with = grow_tree(params, Seed{3}), without = grow_tree(plain, Seed{3});
  EXPECT_EQ(with.find_fault(), "");
  ASSERT_GT(with.organs.size(), without.organs.size());
  EXPECT_EQ(with.prototypes.back().name, "knot");
  for (std::size_t i = without.organs.size(); i < with.organs.size(); ++i) {
    std::int32_t node = with.organs.node[i];
    EXPECT_EQ(with.organs.position[i], with.skeleton.position[static_cast<std::size_t>(node)]);
  }
}

TEST(Tree, HasTheSameShapesAtAllTimes) {
  TreeParams params = sapling();
  params.years = 40, params.species.clear_trunk = 8;
  TreeSite site{&params, Vec3(0), Quat(1, 0, 0, 0), 1, Seed{3}};
  Grove grove = grow_trees({&site, 1}, true, Seed{1});
  ASSERT_FALSE(grove.trees[0].scars.empty());
  std::vector<std::string> last;
  for (double year : {0.5, 10.0, 25.0, 40.0}) {
    std::vector<std::string> names;
    for (const Prototype& p : tree_model(params, grove.trees[0], year, {0.4, 1}, Seed{2}).prototypes)
      names.push_back(p.name);
    EXPECT_TRUE(last.empty() || names == last) << year;
    last = names;
  }
}

/// A ring of a tree's stem: how often the picture goes round it, and its middle.
struct Ring {
  float round = 0;
  Vec3 middle{0};
};

/// The rings at a year, by how far the picture has come up the stem, in thousandths of it.
std::map<int, Ring> stem_pictures(const TreeParams& params, const GrownTree& tree, double year) {
  Model model = tree_model(params, tree, year, {0.4, 1}, Seed{2});
  EXPECT_EQ(model.find_fault(), "");
  EXPECT_EQ(model.girth.size(), model.skeleton.size());
  TubeShape shape;
  shape.wrap = 0.05;
  shape.girth = model.girth;
  Surface wood = tube_surface(model.skeleton, shape);
  std::map<int, Ring> rings;
  // The stem is the first tube; it ends where the picture begins anew.
  for (std::size_t i = 0; i < wood.uv.size() && (i == 0 || wood.uv[i].y >= wood.uv[i - 1].y); ++i) {
    Ring& ring = rings[static_cast<int>(std::lround(wood.uv[i].y * 1000))];
    if (wood.uv[i].x == 0) ring.middle = wood.position[i];
    ring.round = std::max(ring.round, wood.uv[i].x);
    // Half way round is the other side.
    if (std::abs(wood.uv[i].x * 2 - 7) < 1e-4f) ring.middle = (ring.middle + wood.position[i]) / 2.0f;
  }
  rings.erase(std::prev(rings.end()));  // the tip: one place on the picture for each side
  return rings;
}

TEST(Tree, APictureOfBarkStaysOnTheStemThatGrows) {
  TreeParams params = sapling();
  TreeSite site{&params, Vec3(0), Quat(1, 0, 0, 0), 1, Seed{5}};
  Grove grove = grow_trees({&site, 1}, true, Seed{1});
  std::map<int, Ring> last = stem_pictures(params, grove.trees[0], 12.5);
  for (const auto& [up, ring] : last) EXPECT_EQ(ring.round, 7) << "a whole number of times, all along";
  int same = 0, moved = 0;
  for (double year : {7.3, 9.0, 11.9}) {
    for (const auto& [up, ring] : stem_pictures(params, grove.trees[0], year)) {
      auto then = last.find(up);
      if (then == last.end()) continue;
      ++(glm::distance(then->second.middle, ring.middle) < 0.002f ? same : moved);
    }
  }
  EXPECT_GT(same, 30) << "thin or thick, a place on the stem shows the same part of the picture";
  EXPECT_LT(moved, 4) << "but where the shoot is still growing";
}

/// A grove of trees of these ages, as factors of twenty years.
Grove grove_of(const std::vector<double>& ages, const TreeParams& params) {
  std::vector<TreeSite> sites;
  for (double age : ages)
    sites.push_back({&params, Vec3(3.0f * static_cast<float>(sites.size()), 0, 0), Quat(1, 0, 0, 0), age,
                     Seed{sites.size()}});
  return grow_trees(sites, false, Seed{1});
}

std::size_t internodes_of(const Grove& grove) {
  std::size_t sum = 0;
  for (const GrownTree& tree : grove.trees) sum += tree.sizes.back().internodes;
  return sum;
}

TEST(Tree, ABudgetMakesAllTreesOfAGroveYounger) {
  TreeParams params;
  params.years = 20;
  params.budget.internodes = 1500;
  for (const auto& ages : std::vector<std::vector<double>>{{1}, {1, 1, 1}, {1, 0.6, 0.3}}) {
    Grove held = grove_of(ages, params);
    EXPECT_GT(held.cycles, 3);
    EXPECT_LT(held.cycles, 20);
    EXPECT_LE(internodes_of(held), 1500u);
    auto i = held.trees.begin();
    for (double age : ages)
      EXPECT_NEAR(static_cast<double>((i++)->sizes.size()), std::max(1.0, age * held.cycles), 0.51);
    // As if the preset had said so many years; with one more they are too many.
    TreeParams plain = params;
    plain.budget = {}, plain.years = held.cycles;
    EXPECT_EQ(internodes_of(grove_of(ages, plain)), internodes_of(held));
    plain.years = held.cycles + 1;
    EXPECT_GT(internodes_of(grove_of(ages, plain)), 1500u);
  }
}

TEST(Tree, ABudgetThatIsNotReachedChangesNothing) {
  TreeParams params = sapling(), held = params;
  held.budget.internodes = 1'000'000;
  EXPECT_EQ(grow_tree(held, Seed{3}).skeleton.position, grow_tree(params, Seed{3}).skeleton.position);
}

TEST(Tree, SecondsThatNobodyCountedAreTheSameOnAllMachines) {
  GrowthBudget budget{0, 0.01};
  EXPECT_EQ(budget.most(), 3000u);
  budget.internodes = 500;
  EXPECT_EQ(budget.most(), 500u);
  EXPECT_EQ(GrowthBudget{}.most(), 0u);
}

TEST(Tree, LeavesMayBePictures) {
  TreeParams params = sapling();
  params.leaves.picture = LeafLook{};
  params.coat = BarkCoat{};
  params.coat->pixels = 32;
  Model model = grow_tree(params, Seed{3});
  EXPECT_EQ(model.find_fault(), "");
  Look look;
  look.branches.coat = params.coat;
  look.leaves = pictured_leaves(params);
  std::vector<Drawing> drawn = drawings(look);
  const auto& named = model.prototypes[0].parts[0].pictures;
  ASSERT_EQ(named.size(), params.leaves.picture->colors.size());
  for (std::size_t i = 0; i < named.size(); ++i) EXPECT_EQ(drawn[i].names[0], named[i]);
  EXPECT_EQ(drawn.back().names.size(), 2u) << "of bark";
}

}  // namespace
}  // namespace frond
