#include "settings/lawn.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

constexpr int kPixels = 200;

/// A small lawn with a map of its whole land, grey by a function of the place.
std::vector<Patch> grass(const std::function<float(Vec2)>& grey) {
  LawnShape shape;
  shape.blade = 0.1, shape.extent = 4, shape.blades = 100;
  if (grey) {
    std::vector<float> pixels;
    for (int i = 0; i < kPixels * kPixels; ++i)
      pixels.push_back(
          grey((Vec2(i % kPixels, i / kPixels) + 0.5f) * static_cast<float>(kLawnSown / kPixels) -
               static_cast<float>(kLawnSown / 2)));
    shape.map.width = shape.map.height = kPixels;
    shape.map.grey = std::make_shared<const std::vector<float>>(std::move(pixels));
  }
  Lawn lawn({}, shape, Quality::draft, 10, Seed{3});
  TakenSpots none;
  lawn.strew(none);
  return lawn.turf_patches;
}

TEST(Lawn, HasAllItsGrassWhereItsMapIsWhiteAndNoneWhereItIsBlack) {
  std::vector<Patch> all = grass({}), white = grass([](Vec2) { return 1.0f; });
  ASSERT_EQ(white.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(white[i].at, all[i].at);
    EXPECT_EQ(white[i].shape, all[i].shape);
  }
  EXPECT_TRUE(grass([](Vec2) { return 0.0f; }).empty());
}

TEST(Lawn, FollowsTheEdgesOfItsMap) {
  std::vector<Patch> half = grass([](Vec2 at) { return at.x < 0 ? 1.0f : 0.0f; });
  EXPECT_GT(half.size(), 50u);
  for (const Patch& patch : half) EXPECT_LT(patch.at.x, 0.6f) << "a pixel is a metre wide, and goes over";
}

}  // namespace
}  // namespace frond
