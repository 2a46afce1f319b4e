#include "studio/tiles.h"

#include <gtest/gtest.h>

#include "core/linear.h"

namespace frond {
namespace {

Material stone(const Color& color, double scale = 0.2) {
  Material m;
  m.matter = Matter::granite;
  m.color = color, m.second = color;
  m.scale = scale;
  return m;
}

TEST(Tiles, AreSharedByMaterialsThatDifferInLittleButBrightness) {
  Tile one = *tile_of(stone({0.50f, 0.48f, 0.45f})), darker = *tile_of(stone({0.35f, 0.335f, 0.31f}));
  EXPECT_EQ(one.colors, darker.colors);
  EXPECT_NE(one.colors, one.normals);
  Vec3 ratio = one.light / darker.light,
       expected = linear(Color{0.50f, 0.48f, 0.45f}) / linear(Color{0.35f, 0.335f, 0.31f});
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(ratio[c], expected[c], 1e-3) << "each keeps its own colour";
  EXPECT_NE(one.colors, tile_of(stone({0.6f, 0.2f, 0.1f}))->colors);
  EXPECT_NE(one.colors, tile_of(stone({0.50f, 0.48f, 0.45f}, 0.8))->colors);
}

TEST(Tiles, AreAsWideAsThePatternOfTheMaterialItself) {
  EXPECT_NEAR(tile_of(stone({0.5f, 0.5f, 0.5f}, 0.21))->wide / tile_of(stone({0.5f, 0.5f, 0.5f}, 0.20))->wide,
              1.05, 1e-6);
}

TEST(Tiles, AreNotForWhatHasNoPatternOrAPictureOfItsOwn) {
  Material plain;
  EXPECT_FALSE(tile_of(plain)) << "plain colours need none";
  Material shell = stone({1, 1, 1});
  shell.picture = "shell.png";
  EXPECT_FALSE(tile_of(shell));
  Material pot;
  pot.matter = Matter::ceramic;
  EXPECT_FALSE(tile_of(pot)) << "what is painted on a vessel goes once round it";
}

TEST(Tiles, NameBothPicturesThatTheirDrawingMakes) {
  Material m = stone({0.5f, 0.5f, 0.5f});
  Tile tile = *tile_of(m);
  EXPECT_EQ(tile_drawing(m, {}).names, (std::vector<std::string>{tile.colors, tile.normals}));
}

}  // namespace
}  // namespace frond
