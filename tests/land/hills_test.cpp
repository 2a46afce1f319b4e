#include "land/hills.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frond {
namespace {

constexpr double kSize = 1000;

double eroded(Vec2 at, double erosion, double spacing = 5) {
  return eroded_hill_noise(at, kSize, 0.6, erosion, spacing, Seed{4});
}

Vec2 spot(int i) { return Vec2(37.1f * static_cast<float>(i % 50), 41.3f * static_cast<float>(i / 50)); }

TEST(ErodedHills, WithoutErosionAreTheHills) {
  for (int i = 0; i < 100; ++i) EXPECT_EQ(eroded(spot(i), 0), hill_noise(spot(i), kSize, 0.6, 5, Seed{4}));
}

TEST(ErodedHills, AreContinuous) {
  for (int i = 0; i < 2500; ++i)
    EXPECT_NEAR(eroded(spot(i), 1), eroded(spot(i) + Vec2(0.02f, 0.02f), 1), 0.008) << i;
}

TEST(ErodedHills, LeaveOutWhatLinesCannotShow) {
  // Lines a quarter of the size apart show the hills alone, and these change little between them.
  double fine = 0, coarse = 0;
  for (int i = 0; i < 2500; ++i) {
    fine += std::abs(eroded(spot(i) + Vec2(40, 0), 1) - eroded(spot(i), 1));
    coarse += std::abs(eroded(spot(i) + Vec2(40, 0), 1, 250) - eroded(spot(i), 1, 250));
  }
  EXPECT_GT(fine, 1.5 * coarse);
}

TEST(ErodedHills, GulliesLeadDown) {
  // Across the slope of the land the ground goes up and down far more than along it.
  double across = 0, along = 0;
  for (int i = 0; i < 2500; ++i) {
    Vec2 at = spot(i);
    auto land = [&](Vec2 p) { return hill_noise(p, kSize, 0.6, 120, Seed{4}); };
    Vec2 slope(land(at + Vec2(20, 0)) - land(at - Vec2(20, 0)),
               land(at + Vec2(0, 20)) - land(at - Vec2(0, 20)));
    if (glm::length(slope) < 0.06f) continue;
    Vec2 down = glm::normalize(slope), aside(-down.y, down.x);
    auto worn = [&](Vec2 p) { return eroded(p, 1, 40) - land(p); };
    across += std::abs(worn(at + 60.0f * aside) - worn(at)),
        along += std::abs(worn(at + 60.0f * down) - worn(at));
  }
  EXPECT_GT(across, 1.4 * along);
}

}  // namespace
}  // namespace frond
