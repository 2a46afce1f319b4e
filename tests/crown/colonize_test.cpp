#include "crown/colonize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frond {
namespace {

TEST(Colonize, AFlatEnvelopeTakesNoMoreMemoryThanItsPoints) {
  // 50 km wide: a grid as fine as its height would have a billion cells.
  Envelope disc(ConeCrown{{0, 1, 0}, 0.01, 25000, 25000});
  Colonization how;
  how.attractors = 50;
  how.most_nodes = 10;
  EXPECT_TRUE(colonize(disc, how, Seed{1}).ok());
}

TEST(Colonize, StaysInTheEnvelopeAndFillsIt) {
  Envelope ball(EllipsoidCrown{{0, 5, 0}, {2, 2, 2}});
  Colonization how;
  how.attractors = 3000;
  how.jitter = 0;
  Result<Skeleton> s = colonize(ball, how, Seed{1});
  ASSERT_TRUE(s.ok());
  EXPECT_EQ(s->find_fault(), "");
  EXPECT_GT(s->size(), 800u);
  for (std::size_t i = 0; i < s->size(); ++i) {
    Vec3 p = s->position[i];
    if (p.y < 3) continue;  // the stem
    EXPECT_LT(glm::distance(p, Vec3(0, 5, 0)), 2 + how.step);
    if (s->parent[i] != Skeleton::kRoot) {
      EXPECT_NEAR(glm::distance(p, s->position[s->parent[i]]), how.step, 1e-4);
    }
  }
  // Coverage: nearly every place of the envelope has a branch within reach.
  int bare = 0;
  std::vector<Vec3> places = ball.sample(500, Seed{77});
  for (Vec3 at : places) {
    float nearest = 1e9f;
    for (Vec3 p : s->position) nearest = std::min(nearest, glm::distance(p, at));
    bare += nearest > 2 * how.kill;
  }
  EXPECT_LT(bare, 15);
}

TEST(Colonize, FewerPointsAreTakenFartherOffByALargerKillDistance) {
  Envelope ball(EllipsoidCrown{{0, 5, 0}, {2, 2, 2}});
  Colonization fine, coarse;
  fine.attractors = coarse.attractors = 3000;
  coarse.kill = 0.7;
  EXPECT_GT(colonize(ball, fine, Seed{2})->size(), 2 * colonize(ball, coarse, Seed{2})->size());
}

TEST(Colonize, GoesThroughAllOfAWideFlatRoom) {
  Envelope disc(EllipsoidCrown{{0, 3, 0}, {6, 0.4f, 6}});
  Colonization how;
  how.attractors = 2500;
  Result<Skeleton> s = colonize(disc, how, Seed{3});
  Vec3 low(1e9f), high(-1e9f);
  for (Vec3 p : s->position) low = glm::min(low, p), high = glm::max(high, p);
  EXPECT_LT(low.x, -5.2f);
  EXPECT_GT(high.x, 5.2f);
  EXPECT_GT(high.z, 5.2f);
}

TEST(Colonize, ManyPointsBecomeManyNodesAndTheLimitHolds) {
  Envelope ball(EllipsoidCrown{{0, 9, 0}, {6, 6, 6}});
  Colonization how;
  how.attractors = 30000;
  how.most_nodes = 2000;
  Result<Skeleton> s = colonize(ball, how, Seed{4});
  EXPECT_GE(s->size(), 2000u);
  EXPECT_LT(s->size(), 6000u);  // a round may end past it
}

TEST(Colonize, AnEmptyRoomIsAnError) {
  Envelope nothing(MeshCrown{});
  EXPECT_FALSE(colonize(nothing, {}, Seed{1}).ok());
}

TEST(Colonize, TheSameSeedIsTheSameTree) {
  Envelope ball(EllipsoidCrown{});
  Colonization how;
  how.attractors = 500;
  EXPECT_EQ(colonize(ball, how, Seed{1})->position, colonize(ball, how, Seed{1})->position);
  EXPECT_NE(colonize(ball, how, Seed{1})->position, colonize(ball, how, Seed{2})->position);
}

TEST(LeafSitesNearTips, LeavesStandNearTipsAtTheirSpacing) {
  Skeleton s;
  for (int i = 0; i <= 40; ++i) s.add(Vec3(0, 0.1 * i, 0), 0.01f, i - 1, 0);
  set_tip_distances(s);
  std::vector<LeafSite> leaves = leaf_sites_near_tips(s, 1.0, 0.05, radians(50.0), Seed{1});
  EXPECT_NEAR(static_cast<double>(leaves.size()), 22, 1);
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    EXPECT_GE(leaves[i].position.y, 2.8f);
    if (i > 0) {
      EXPECT_NEAR(leaves[i].position.y - leaves[i - 1].position.y, 0.05, 1e-4);
    }
    Vec3 heading = leaves[i].turn * Vec3(0, 1, 0), face = leaves[i].turn * Vec3(0, 0, 1);
    EXPECT_NEAR(heading.y, std::cos(radians(50.0)), 0.3);
    EXPECT_GT(face.y, 0.3f);  // a leaf shows its face to the tip
  }
}

}  // namespace
}  // namespace frond
