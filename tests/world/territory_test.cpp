#include "world/territory.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

TEST(Territories, TheBorderOfEqualsIsHalfWay) {
  Territories two({{{0, 0, 0}, 0.3f, 0.3f}, {{0.4f, 0, 0}, 0.3f, 0.3f}});
  EXPECT_NEAR(two.room(0, {0.2f, 0, 0}), 0, 1e-6);
  EXPECT_NEAR(two.room(0, {0.1f, 0, 0}), 0.1, 1e-5);
  EXPECT_LT(two.room(0, {0.3f, 0, 0}), 0);
  EXPECT_GT(two.room(1, {0.3f, 0, 0}), 0);
}

TEST(Territories, NoPlaceIsOfTwoAndRoomIsNeverTooMuch) {
  std::vector<Claim> claims{
      {{0, 0, 0}, 0.3f, 0.2f}, {{0.3f, 0.1f, 0}, 0.2f, 0.5f}, {{0.1f, 0, 0.3f}, 0.4f, 0.1f}};
  Territories all(claims);
  for (int i = 0; i < 4000; ++i) {
    Vec3 at(static_cast<float>(i % 16) / 20 - 0.2f, static_cast<float>(i / 16 % 16) / 20,
            static_cast<float>(i / 256) / 20 - 0.2f);
    int owners = 0;
    for (std::size_t own = 0; own < claims.size(); ++own) {
      float room = all.room(own, at);
      owners += room > 0;
      if (room <= 0) continue;
      // No place within that room is somebody else's.
      for (Vec3 way : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.6f, 0.8f, 0),
                       Vec3(0, -0.6f, -0.8f)})
        EXPECT_GE(all.room(own, at + way * (0.999f * std::min(room, 5.0f))), -1e-4f);
    }
    EXPECT_LE(owners, 1);
  }
}

TEST(Territories, WhereANeighbourIsGoneItsSpaceIsFree) {
  Claim one{{0, 0, 0}, 0.3f, 0.3f}, two{{0.4f, 0, 0}, 0.3f, 0.3f};
  EXPECT_LT(Territories({one, two}).room(0, {0.3f, 0, 0}), 0);
  EXPECT_EQ(Territories({one}).room(0, {0.3f, 0, 0}), Territories::kOpen);
}

TEST(Territories, RivalsTakeTheShareOfTheSkyThatTheyCover) {
  // A wall of a colony to one side takes nearly half, a flat one far off next to nothing.
  Territories wall({{{0, 0, 0}, 0.2f, 0.2f}, {{1.2f, 0, 0}, 1.1f, 30}});
  EXPECT_NEAR(wall.sky(0, {0, 0.1f, 0}), 0.5f, 0.12f);
  EXPECT_GT(wall.sky(0, {-0.2f, 0.1f, 0}), wall.sky(0, {0.05f, 0.1f, 0}));
  Territories flat({{{0, 0, 0}, 0.2f, 0.2f}, {{0.9f, 0, 0}, 0.4f, 0.02f}});
  EXPECT_GT(flat.sky(0, {0, 0.1f, 0}), 0.95f);
  EXPECT_EQ(Territories({{{0, 0, 0}, 0.2f, 0.2f}}).sky(0, {0, 0.1f, 0}), 1) << "alone";
}

}  // namespace
}  // namespace frond
