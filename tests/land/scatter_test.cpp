#include "land/scatter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frond {
namespace {

TEST(Scatter, KeepsItsDistances) {
  TakenSpots taken;
  taken.add({Vec2(0, 0), 0.5f});
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
    taken.add(spot);
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
