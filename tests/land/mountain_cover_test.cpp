#include "land/mountain_cover.h"

#include <gtest/gtest.h>

#include "core/seed.h"

namespace frond {
namespace {

using namespace mountain_cover;

constexpr AltitudeLines kLines{.trees = 500, .snow = 1500, .shaded = {1, 0}};

/// The mean over many places of one altitude, slope toward +x or -x and curvature.
double mean_cover(double height, double slope, double hollow = 0) {
  double sum = 0;
  for (int i = 0; i < 200; ++i)
    sum += mountain_cover_at(kLines, {Vec2(311 * i, 97 * i), height, Vec2(slope, 0), hollow});
  return sum / 200;
}

TEST(MountainCover, FollowsAltitude) {
  EXPECT_NEAR(mean_cover(100, 0.4), kWood, 0.01);
  EXPECT_NEAR(mean_cover(580, 0.4), kHeath, 0.1);
  EXPECT_NEAR(mean_cover(2200, 0.4), kSnow, 0.02);
  double before = 0;
  for (double height = 100; height < 2500; height += 100) {
    double cover = mean_cover(height, 0.4);
    EXPECT_GE(cover, before - 1e-6) << height;
    before = cover;
  }
}

TEST(MountainCover, SteepLandIsRock) {
  for (double height : {100, 700, 1300, 2200}) EXPECT_NEAR(mean_cover(height, 1.7), kRock, 0.03) << height;
}

TEST(MountainCover, SnowReachesDownInGulliesAndShade) {
  double shaded = mean_cover(1450, -0.6), sunny = mean_cover(1450, 0.6);
  EXPECT_GT(shaded, sunny + 0.03) << "falls toward +x";
  EXPECT_GT(mean_cover(1200, -0.8, 0.2), mean_cover(1200, -0.8, 0) + 0.03);
}

TEST(MountainCover, ScreeLiesInGullies) {
  EXPECT_NEAR(mean_cover(800, 0.7, 0.3), kScree, 0.06);
  EXPECT_LT(mean_cover(800, 0.5, -0.1), kScree - 0.1);
}

TEST(MountainCover, HasSoftEdges) {
  for (int i = 0; i < 2000; ++i) {
    Seed seed = Seed{3}.child(static_cast<std::uint64_t>(i));
    MountainPlace place{Vec2(seed.child(0).range(-9000, 9000), seed.child(1).range(-9000, 9000)),
                        seed.child(2).range(0, 2500), Vec2(seed.child(3).range(-2, 2), 0.1f),
                        seed.child(4).range(-0.3, 0.3)};
    MountainPlace beside = place;
    beside.at.x += 1, beside.height += 1, beside.slope.x += 0.005f, beside.hollow += 0.001;
    EXPECT_NEAR(mountain_cover_at(kLines, place), mountain_cover_at(kLines, beside), 0.05) << i;
  }
}

}  // namespace
}  // namespace frond
