#include "images/bark.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frond {
namespace {

constexpr BarkPattern kPatterns[] = {BarkPattern::furrowed, BarkPattern::plated, BarkPattern::smooth,
                                     BarkPattern::banded};

/// How much neighbours differ on average: columns x and x + 1.
double step_across(const Grid& g, int x) {
  double sum = 0;
  for (int y = 0; y < g.height; ++y) sum += std::abs(g.wrapped(x + 1, y) - g.at(x, y));
  return sum / g.height;
}
double step_along(const Grid& g, int y) {
  double sum = 0;
  for (int x = 0; x < g.width; ++x) sum += std::abs(g.wrapped(x, y + 1) - g.at(x, y));
  return sum / g.width;
}

TEST(Bark, HasNoSeamRoundTheBranchNorAlongIt) {
  for (BarkPattern pattern : kPatterns) {
    BarkImage bark;
    bark.pattern = pattern;
    BarkMaps maps = bark_maps(bark, 96, 192, Seed{5});
    double across = 0, along = 0;
    for (int x = 0; x < 95; ++x) across = std::max(across, step_across(maps.height, x));
    for (int y = 0; y < 191; ++y) along = std::max(along, step_along(maps.height, y));
    EXPECT_LE(step_across(maps.height, 95), across) << static_cast<int>(pattern);
    EXPECT_LE(step_along(maps.height, 191), along) << static_cast<int>(pattern);
    EXPECT_GT(across, 0.001);
  }
}

TEST(Bark, KnotsAndLenticelsFitRoundTheBranchAndShow) {
  for (BarkPattern pattern : kPatterns) {
    BarkImage plain, marked;
    plain.pattern = marked.pattern = pattern;
    marked.knots = 4, marked.lenticels = 0.6;
    BarkMaps without = bark_maps(plain, 96, 192, Seed{5}), maps = bark_maps(marked, 96, 192, Seed{5});
    double across = 0, along = 0, changed = 0;
    for (int x = 0; x < 95; ++x) across = std::max(across, step_across(maps.height, x));
    for (int y = 0; y < 191; ++y) along = std::max(along, step_along(maps.height, y));
    EXPECT_LE(step_across(maps.height, 95), across) << static_cast<int>(pattern);
    EXPECT_LE(step_along(maps.height, 191), along) << static_cast<int>(pattern);
    for (std::size_t i = 0; i < maps.tone.data.size(); ++i)
      changed += std::abs(maps.tone.data[i] - without.tone.data[i]) > 0.05;
    double share = changed / static_cast<double>(maps.tone.data.size());
    EXPECT_GT(share, 0.05) << static_cast<int>(pattern);
    EXPECT_LT(share, 0.95) << static_cast<int>(pattern);
  }
}

TEST(Bark, StaysInItsRangeAndUsesIt) {
  for (BarkPattern pattern : kPatterns) {
    BarkImage bark;
    bark.pattern = pattern;
    BarkMaps maps = bark_maps(bark, 128, 256, Seed{6});
    auto [low, high] = std::minmax_element(maps.height.data.begin(), maps.height.data.end());
    EXPECT_GE(*low, 0);
    EXPECT_LE(*high, 1);
    EXPECT_GT(*high - *low, 0.3) << static_cast<int>(pattern);
  }
}

TEST(Bark, FurrowsRunAlongTheBranch) {
  BarkImage bark;
  BarkMaps maps = bark_maps(bark, 128, 256, Seed{2});
  double across = 0, along = 0;
  for (int x = 0; x < 128; ++x) across += step_across(maps.height, x) / 128;
  for (int y = 0; y < 256; ++y) along += step_along(maps.height, y) / 256;
  EXPECT_GT(across, 1.5 * along);
  // Twice the ridges, about twice the crossings of the middle height.
  auto crossings = [&](int ridges) {
    bark.ridges = ridges;
    Grid g = bark_maps(bark, 256, 128, Seed{2}).height;
    double count = 0;
    for (int y = 0; y < g.height; ++y)
      for (int x = 0; x < g.width; ++x) count += (g.at(x, y) > 0.35f) != (g.wrapped(x + 1, y) > 0.35f);
    return count;
  };
  EXPECT_NEAR(crossings(16) / crossings(8), 2, 0.5);
}

TEST(Bark, ItsNormalsAreTheGradient) {
  Grid slope(32, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) slope.at(x, y) = static_cast<float>(x) / 32;
  Raster normals = normal_picture(slope, 32);  // one up for one across: half a right angle
  EXPECT_NEAR(normals.at(16, 16, 0) / 127.5 - 1, -std::sqrt(0.5), 0.01);
  EXPECT_NEAR(normals.at(16, 16, 1) / 127.5 - 1, 0, 0.01);
  EXPECT_NEAR(normals.at(16, 16, 2) / 127.5 - 1, std::sqrt(0.5), 0.01);
}

TEST(Bark, LightComesFromTheUpperLeft) {
  Grid hill(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      hill.at(x, y) = static_cast<float>(std::exp(-0.01 * ((x - 32) * (x - 32) + (y - 32) * (y - 32))));
  Raster grey(64, 64, 3);
  std::fill(grey.data.begin(), grey.data.end(), static_cast<std::uint8_t>(128));
  Raster lit = lit_picture(grey, normal_picture(hill, 20));
  EXPECT_GT(lit.at(26, 26), lit.at(38, 38) + 20);
}

TEST(Bark, AnotherSeedIsAnotherBark) {
  BarkImage bark;
  EXPECT_EQ(bark_maps(bark, 32, 32, Seed{1}).height.data, bark_maps(bark, 32, 32, Seed{1}).height.data);
  EXPECT_NE(bark_maps(bark, 32, 32, Seed{1}).height.data, bark_maps(bark, 32, 32, Seed{2}).height.data);
}

}  // namespace
}  // namespace frond
