#include "organisms/tree.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace frond {
namespace {

TreeParams sapling() {
  TreeParams params;
  params.years = 12;
  return params;
}

TEST(Tree, IsAWholeModel) {
  Model model = grow_tree(sapling(), Seed{3});
  EXPECT_EQ(model.check(), "");
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
  EXPECT_EQ(year_at(growth, 20, 0), 0);
  EXPECT_NEAR(year_at(growth, 20, 7), 10.25, 1e-9);
  EXPECT_NEAR(year_at(growth, 20, 99), 20.5, 1e-9);
  EXPECT_NEAR(year_at({}, 20, 0), 20.5, 1e-9);
}

TEST(Tree, YoungerOnesBeginLater) {
  TreeParams params = sapling();
  std::vector<TreeSite> sites(2);
  for (TreeSite& site : sites) site.params = &params;
  sites[1].foot = Vec3(30, 0, 0);
  sites[1].age = 0.5;
  Grove grove = grow_trees(sites, true, Seed{1});
  EXPECT_EQ(grove.years, 12);
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
    EXPECT_EQ(model.check(), "") << "year " << year;
    EXPECT_GE(model.skeleton.size() + 50, last);
    last = model.skeleton.size();
  }
}

}  // namespace
}  // namespace frond
