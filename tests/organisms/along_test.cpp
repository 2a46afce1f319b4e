// Curves along the parent, of kinds whose branches grow by other laws.

#include <gtest/gtest.h>

#include "organisms/colonized/colonized.h"
#include "organisms/tree/tree.h"
#include "pruning/address.h"

namespace frond {
namespace {

/// The lengths of the ways from where branches leave the stem to all nodes that they bear, in order.
std::vector<float> reaches(const Model& m) {
  std::vector<AxisNode> axes = axis_nodes(m);
  const Skeleton& s = m.skeleton;
  std::vector<float> along(s.size(), -1), list;
  std::vector<std::int32_t> starts = axis_starts({s.parent, axes});
  for (std::size_t i = 0; i < s.size(); ++i) {
    std::int32_t p = s.parent[i];
    if (p < 0 || axes[i].number < 0 || axes[starts[i]].number < 0) continue;
    float length = glm::distance(s.position[i], s.position[p]);
    if (along[p] >= 0)
      along[i] = along[p] + length;
    else if (starts[p] == 0 && axes[i].number > 0)
      along[i] = length;
    if (along[i] >= 0) list.push_back(along[i]);
  }
  return list;
}

void expect_half(const Model& whole, const Model& half) {
  EXPECT_EQ(half.find_fault(), "");
  const std::vector<float> a = reaches(whole), b = reaches(half);
  ASSERT_GT(a.size(), 50u);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(b[i], a[i] / 2, 1e-3f) << i;
}

const Curve kHalf({{0, 0.5f}, {1, 0.5f}}), kOne({{0, 1}, {0.4f, 1}, {1, 1}});

TEST(Along, TheBranchesOfATreeByLightAreHalfAsLongWhereTheCurveSaysSo) {
  TreeParams params;
  params.years = 10;
  params.knots = 0;
  const Model whole = grow_tree(params, Seed{3});
  params.along.branches.length = kOne;
  EXPECT_EQ(grow_tree(params, Seed{3}).skeleton.position, whole.skeleton.position);
  params.along.branches.length = kHalf;
  expect_half(whole, grow_tree(params, Seed{3}));
  // Thin branches leave the stem as it is.
  params.along.branches = {};
  params.along.branches.radius = kHalf;
  const Model thin = grow_tree(params, Seed{3});
  ASSERT_EQ(thin.skeleton.size(), whole.skeleton.size());
  EXPECT_EQ(thin.skeleton.radius[0], whole.skeleton.radius[0]);
  double sum = 0, all = 0;
  for (std::size_t i = 0; i < thin.skeleton.size(); ++i)
    if (thin.skeleton.order[i] > 0) sum += thin.skeleton.radius[i], all += whole.skeleton.radius[i];
  EXPECT_LT(sum, 0.7 * all);
}

TEST(Along, TheBranchesOfAColonizedTreeAreHalfAsLongWhereTheCurveSaysSo) {
  ColonizedParams params;
  params.growth_into.attractors = 300;
  const Result<Model> whole = grow_colonized_tree(params, Seed{3});
  params.along.branches.length = kOne;
  EXPECT_EQ(grow_colonized_tree(params, Seed{3})->skeleton.position, whole->skeleton.position);
  params.along.branches.length = kHalf;
  const Result<Model> half = grow_colonized_tree(params, Seed{3});
  ASSERT_TRUE(whole && half);
  expect_half(*whole, *half);
}

}  // namespace
}  // namespace frond
