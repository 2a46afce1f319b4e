#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/ground.h"
#include "geometry/scatter.h"
#include "geometry/smooth.h"
#include "geometry/stone.h"
#include "shapes.h"

namespace frond {
namespace {

TEST(Smooth, KeepsTheNodesAndAddsBetween) {
  Skeleton coarse = candelabrum(6, Seed{1});
  Skeleton fine = smooth(coarse, 4);
  EXPECT_EQ(fine.check(), "");
  EXPECT_EQ(fine.size(), 1 + (coarse.size() - 1) * 4);
  for (std::size_t i = 1; i < coarse.size(); ++i)
    EXPECT_EQ(fine.position[1 + (i - 1) * 4 + 3], coarse.position[i]) << i;
}

TEST(Smooth, HasNoKinksInsideABranch) {
  Skeleton coarse;
  for (int i = 0; i < 6; ++i)
    coarse.add(Vec3(0.1f * static_cast<float>(i % 2), 0.2f * static_cast<float>(i), 0), 0.1f, i - 1, 0);
  Skeleton fine = smooth(coarse, 8);
  for (std::size_t i = 2; i < fine.size(); ++i) {
    Vec3 a = glm::normalize(fine.position[i - 1] - fine.position[i - 2]);
    Vec3 b = glm::normalize(fine.position[i] - fine.position[i - 1]);
    EXPECT_GT(glm::dot(a, b), std::cos(radians(22.0f))) << i;
  }
}

TEST(Stone, IsClosedAndWellFormed) {
  for (int detail = 0; detail <= 3; ++detail) {
    Surface s = stone_surface({Seed{4}}, detail);
    EXPECT_EQ(s.check(), "");
    EXPECT_EQ(s.triangle.size(), 20u << (2 * detail));
    // Each edge is run once in each direction.
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (auto [a, b, c] : s.triangle) ++edges[{a, b}], ++edges[{b, c}], ++edges[{c, a}];
    for (auto [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
    // Outward: its volume is positive.
    double volume = 0;
    for (auto [a, b, c] : s.triangle)
      volume += glm::dot(s.position[a], glm::cross(s.position[b], s.position[c])) / 6;
    EXPECT_GT(volume, 0.05);
  }
}

TEST(Ground, MeshLiesOnTheHeights) {
  Ground ground{Seed{2}, 0.2, 2.5};
  Surface s = ground_surface(ground, Vec2(0), 20, 40);
  EXPECT_EQ(s.check(), "");
  for (const Vec3& p : s.position) {
    if (std::hypot(p.x, p.z) < 10) {
      EXPECT_NEAR(p.y, ground_height(ground, p.x, p.z), 1e-4);
    }
    EXPECT_LE(std::abs(p.y), 0.5);
  }
  for (const Vec3& n : s.normal) EXPECT_GT(n.y, 0.5f);
}

TEST(Scatter, KeepsItsDistances) {
  TakenSpots taken;
  taken.take({Vec2(0, 0), 0.5f});
  std::vector<Spot> spots = scatter(Vec2(0), 0, 3, 0.3f, 40, taken, Seed{9});
  EXPECT_GT(spots.size(), 25u);
  for (std::size_t i = 0; i < spots.size(); ++i) {
    EXPECT_LE(glm::length(spots[i].at), 3);
    EXPECT_GE(glm::length(spots[i].at), 0.8f);
    for (std::size_t k = 0; k < i; ++k) EXPECT_GE(glm::distance(spots[i].at, spots[k].at), 0.6f);
  }
}

TEST(Scatter, FindsWhatIsTakenAsALookAtEachWould) {
  TakenSpots taken;
  std::vector<Spot> all;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    Seed own = Seed{7}.child(i);
    // Of all sizes, some at one place, some far off.
    float reach = i % 7 == 0 ? 0.001f : i % 11 == 0 ? 40000.0f : 20.0f;
    Spot spot{Vec2(own.child(0).range(-reach, reach), own.child(1).range(-reach, reach)),
              static_cast<float>(std::pow(own.child(2).unit(), 6.0))};
    bool free = std::none_of(all.begin(), all.end(), [&](const Spot& other) {
      return glm::distance(spot.at, other.at) < spot.radius + other.radius;
    });
    ASSERT_EQ(taken.free(spot.at, spot.radius), free) << i;
    if (!free && i % 2) continue;
    taken.take(spot);
    all.push_back(spot);
  }
}

TEST(Scatter, AMillionAskedForInAFullRingIsGivenUpAtOnce) {
  TakenSpots taken;
  std::size_t found = scatter(Vec2(0), 0, 23, 0.35f, 1'000'000, taken, Seed{3}).size();
  EXPECT_GT(found, 2100u);
  EXPECT_LT(found, 2400u);
  EXPECT_EQ(taken.list().size(), found);
}

TEST(Scatter, GivesUpWhereThereIsNoRoom) {
  TakenSpots taken;
  EXPECT_LT(scatter(Vec2(0), 0, 1, 0.5f, 100, taken, Seed{1}).size(), 8u);
}

}  // namespace
}  // namespace frond
