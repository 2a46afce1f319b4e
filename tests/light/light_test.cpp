#include "light/light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace frond {
namespace {

const Eye kEye = eye_toward(Vec3(0, 2, 6), Vec3(0, 1.7f, 5), 0.6, 0.45, 0.004);

Ambience even_sky() {
  Ambience sky;
  sky.zenith = sky.horizon = sky.below = Vec3(1);
  sky.ground = Vec3(0);
  return sky;
}

SoftLight field() { return SoftLight({kEye}, {Vec3(-8, -1, -8), Vec3(8, 5, 8)}, 16, 0.1); }

/// A square wall through a place, of points.
void add_wall(SoftLight& grid, Vec3 middle, Vec3 along, Vec3 up, Vec3 normal) {
  constexpr float kStep = 0.02f;
  for (float u = -3; u < 3; u += kStep)
    for (float v = -3; v < 3; v += kStep)
      grid.add(middle + u * along + v * up, kStep * kStep, Vec3(0), facing(normal) | facing(-normal), 6);
}

/// The mean of the light on what faces upward within half a metre of a place.
float light_at(const std::vector<Probe>& probes, Vec3 at) {
  float sum = 0;
  int count = 0;
  for (const Probe& probe : probes)
    if (probe.axis == 2 && glm::distance(Vec2(probe.at.x, probe.at.z), Vec2(at.x, at.z)) < 0.5f &&
        std::abs(probe.at.y - at.y) < 2 * probe.cell)
      sum += probe.light.x, ++count;
  EXPECT_GT(count, 0);
  return sum / static_cast<float>(count);
}

TEST(SoftLight, OpenLandSeesAllOfAnEvenSky) {
  SoftLight grid = field();
  grid.add_land([](Vec2) { return 0.0f; }, Vec3(0), 0, 0);
  EXPECT_NEAR(light_at(grid.probes(even_sky(), {&kEye, 1}), Vec3(0)), 1, 0.05);
}

TEST(SoftLight, AWallTakesItsShareOfTheSky) {
  SoftLight grid = field();
  grid.add_land([](Vec2) { return 0.0f; }, Vec3(0), 0, 0);
  add_wall(grid, Vec3(0, 2, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1));
  std::vector<Probe> probes = grid.probes(even_sky(), {&kEye, 1});
  // Before the middle of a wall 6 m long and 5 m high: 0.66 of the sky, by the view factor of a plate that
  // stands upright (Siegel and Howell); nearer by, cells make it thicker than it is. Far off there is most of
  // the sky.
  EXPECT_NEAR(light_at(probes, Vec3(0, 0, 1.5f)), 0.66, 0.08);
  EXPECT_LT(light_at(probes, Vec3(0, 0, 0.6f)), 0.6);
  EXPECT_GT(light_at(probes, Vec3(0, 0, 6)), 0.85);
}

TEST(SoftLight, UnderARoofItIsDim) {
  SoftLight grid = field();
  grid.add_land([](Vec2) { return 0.0f; }, Vec3(0), 0, 0);
  add_wall(grid, Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0, 1, 0));
  std::vector<Probe> probes = grid.probes(even_sky(), {&kEye, 1});
  // A square of 6 m, 1 m above: it hides nine tenths of the sky, each direction weighted by its height.
  EXPECT_NEAR(light_at(probes, Vec3(0)), 0.1, 0.07);
  EXPECT_NEAR(light_at(probes, Vec3(0, 1, 0)), 1, 0.07);
}

/// Leaves in a roof 1 m above the land: that much one-sided area a square metre, in clumps `clump` metres
/// wide that take every second place, or evenly with 0.
SoftLight under_leaves(float area, float clump, float bulk) {
  SoftLight grid = field();
  grid.add_land([](Vec2) { return 0.0f; }, Vec3(0), 0, 0);
  constexpr float kStep = 0.025f;
  for (float x = -6; x < 6; x += kStep) {
    for (float z = -6; z < 6; z += kStep) {
      bool taken =
          clump == 0 || (static_cast<int>((x + 6) / clump) + static_cast<int>((z + 6) / clump)) % 2 == 0;
      if (!taken) continue;
      float all = area * kStep * kStep * (clump == 0 ? 1 : 2);
      grid.add(Vec3(x + 0.5f * kStep, 1.1f, z + 0.5f * kStep), all, Vec3(0), kAllFacings, bulk);
    }
  }
  return grid;
}

float light_under(SoftLight grid) { return light_at(grid.probes(even_sky(), {&kEye, 1}), Vec3(0)); }

TEST(SoftLight, UnderLeavesItIsAsBeersLawHasIt) {
  // Leaves that lie every way stop half of their area of what comes from above, and more aslant. The mean
  // over a hemisphere of exp(-k/cos), each direction weighted by its height, is twice the exponential
  // integral of third order: 0.443 for k = 0.5 and 0.219 for k = 1. Past the rim of the roof comes 0.03 of
  // the sky.
  EXPECT_NEAR(light_under(under_leaves(1, 0, 0)), 0.46, 0.09);
  EXPECT_NEAR(light_under(under_leaves(2, 0, 0)), 0.244, 0.09);
}

TEST(SoftLight, TwigsDoNotWallACellUp) {
  // Of round twigs a quarter of the skin is in the way, however wide the cells are that they are laid in.
  EXPECT_NEAR(light_under(under_leaves(2, 0, 0.01f)), 0.46, 0.09);
  EXPECT_LT(light_under(under_leaves(2, 0, 10)), 0.1);
}

TEST(SoftLight, GapsBetweenClumpsLetMoreIn) {
  float even = light_under(under_leaves(6, 0, 0)), clumped = light_under(under_leaves(6, 0.5f, 0));
  EXPECT_LT(even, 0.15);
  EXPECT_GT(clumped, even + 0.1);
}

TEST(SoftLight, NoCoarseLightReachesWhatIsInView) {
  SoftLight grid = field();
  grid.add_land([](Vec2 at) { return 0.3f * std::sin(2 * at.x); }, Vec3(0.3f), 0, 0);
  int coarse = 0;
  for (const Probe& probe : grid.probes(even_sky(), {&kEye, 1})) {
    if (probe.cell <= 2.1f * grid.cell_at(probe.at)) continue;
    ++coarse;
    EXPECT_FALSE(in_view(kEye, probe.at, 1.45f * probe.cell));
  }
  EXPECT_GT(coarse, 50);
}

TEST(SoftLight, WhatIsSunlitThrowsItsColourAround) {
  SoftLight grid = field();
  grid.add_land([](Vec2) { return 0.0f; }, Vec3(0.5f, 0.25f, 0), 0, 0);
  add_wall(grid, Vec3(0, 2, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1));
  Ambience noon;
  noon.sunlight = Vec3(2);
  noon.ground = Vec3(0);
  Vec3 sum(0);
  float count = 0;
  for (const Probe& probe : grid.probes(noon, {&kEye, 1}))
    if (probe.axis == 4 && std::abs(probe.at.x) < 1 && probe.at.y > 0.3f && probe.at.y < 1.2f &&
        std::abs(probe.at.z) < probe.cell)
      sum += probe.light, ++count;
  ASSERT_GT(count, 0);
  // Half of what a wall sees is the land, which throws back its share of the sun's 2.
  EXPECT_NEAR(sum.x / count, 0.5 * 0.5 * 2, 0.15);
  EXPECT_NEAR(sum.y / sum.x, 0.5, 1e-3);
  EXPECT_NEAR(sum.z, 0, 1e-6);
}

TEST(SoftLight, IsTheSameHoweverManyThreadsAddToIt) {
  auto told = [](int threads) {
    limit_threads(threads);
    SoftLight grid = field();
    grid.add_land([](Vec2 at) { return 0.2f * std::sin(at.x); }, Vec3(0.2f, 0.3f, 0.1f), 0.1f, 1);
    parallel_for(64, [&](std::size_t i) {
      auto turn = static_cast<float>(i);
      for (int k = 0; k < 200; ++k)
        grid.add(Vec3(std::cos(turn), 0.01f * static_cast<float>(k), std::sin(turn)), 0.003f,
                 Vec3(0.1f, 0.4f, 0.1f), kAllFacings, 0);
    });
    Ambience day = even_sky();
    day.sunlight = Vec3(2, 1.8f, 1.5f);
    std::vector<Probe> probes = grid.probes(day, {&kEye, 1});
    limit_threads(0);
    return probes;
  };
  std::vector<Probe> one = told(1), many = told(8);
  ASSERT_EQ(one.size(), many.size());
  ASSERT_GT(one.size(), 1000u);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].at, many[i].at);
    EXPECT_EQ(one[i].light, many[i].light);
  }
}

TEST(SoftLight, CellsGrowWithTheDistance) {
  SoftLight grid = field();
  EXPECT_LT(grid.cell_at(kEye.at + kEye.ahead), grid.cell_at(kEye.at + 8.0f * kEye.ahead));
}

TEST(SoftLight, LargePicturesHaveCellsAsFineAsSmallOnes) {
  auto cell = [](double pixel) {
    Eye eye = kEye;
    eye.pixel = pixel;
    SoftLight grid({eye}, {Vec3(-80, -80, -80), Vec3(80, 80, 80)}, 16, 0.1);
    return grid.cell_at(eye.at + 10.0f * eye.ahead);
  };
  EXPECT_LT(cell(0.002), cell(0.008));
  EXPECT_LE(cell(0.0008), cell(0.002));
  EXPECT_LE(cell(0.0001), cell(0.002));
  EXPECT_LE(cell(0.0001), cell(0.003));
}

}  // namespace
}  // namespace frond
