#include "studio/tiles.h"

#include <gtest/gtest.h>

#include "core/linear.h"
#include "export/materials.h"
#include "settings/settings.h"

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

TEST(Tiles, OfBranchesVaryTheirPlainColorAndRepeatAsExportsHaveIt) {
  BranchLook coral;
  coral.skin = Skin{};
  Tile skin = *tile_of(coral);
  EXPECT_EQ(std::pair(skin.wide, skin.high), Palette::picture_size(coral));
  Vec3 plain = skin.light * linear(coral.plain(0, 1));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(plain[c], 1, 1e-3);
  coral.skin->pores.cell *= 2;
  EXPECT_NE(tile_of(coral)->colors, skin.colors);
  EXPECT_TRUE(skin.varied);
  EXPECT_FALSE(tile_of(stone({0.5f, 0.5f, 0.5f}))->varied);

  BranchLook tree;
  tree.bark = Bark{};
  EXPECT_NE(tile_of(tree)->colors, skin.colors);
  tree.coat = BarkCoat{};
  Tile coat = *tile_of(tree);
  EXPECT_EQ(coat.wide, tree.coat->wrap);
  EXPECT_EQ(coat.high, tree.coat->wrap * tree.coat->aspect);
  EXPECT_EQ(tile_drawing(tree, {}).names, (std::vector<std::string>{coat.colors, coat.normals}));
}

TEST(Tiles, AreNotForBranchesWithoutAPattern) {
  BranchLook look;
  EXPECT_FALSE(tile_of(look));
  look.bark = Bark{.kind = BarkKind::stem};
  EXPECT_FALSE(tile_of(look));
}

TEST(Tiles, OfAVesselAreUnrolledAndItsOwn) {
  Solid pot;
  pot.material.matter = Matter::terracotta;
  pot.surface.position = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  pot.surface.normal.assign(3, {0, 0, 1});
  pot.surface.uv = {{0, 0}, {1, 0}, {0, 1}};
  pot.surface.triangle = {{0, 1, 2}};
  Tile tile = *tile_of(pot);
  EXPECT_TRUE(tile.unrolled);
  EXPECT_EQ(tile_drawing(pot, {}).names, std::vector<std::string>{tile.colors}) << "its form is in the mesh";
  EXPECT_FALSE(json_of(tile).contains("normals"));
  pot.surface.position[2].y = 2;
  EXPECT_NE(tile_of(pot)->colors, tile.colors);
  pot.material.matter = Matter::glass;
  EXPECT_FALSE(tile_of(pot)) << "one sees through it";
  Solid rock;
  rock.material = stone({0.5f, 0.5f, 0.5f});
  EXPECT_FALSE(tile_of(rock)->unrolled);
}

TEST(Tiles, OfABareFloorAreDrawnByItsMacroInItsColors) {
  SceneSetup setup;
  for (const char* setting : {"studio", "meadow", "garden", "forest"}) {
    setup.setting = row_of(setting);
    EXPECT_FALSE(tile_of(setup)) << "grass, litter or nothing is there";
  }
  setup.setting = row_of("underwater");
  std::vector<Picture> drawn = *tile_drawing(setup, {.home = FROND_ROOT}).draw();
  ASSERT_EQ(drawn.size(), 2u);
  EXPECT_EQ(drawn[0].name, tile_of(setup)->colors);
  Raster colors = *read_png(drawn[0].bytes);
  Vec3 mean(0);
  for (std::size_t i = 0; i < colors.data.size(); ++i)
    mean[static_cast<int>(i % 3)] +=
        static_cast<float>(linear(colors.data[i] / 255.0)) * 3 / static_cast<float>(colors.data.size());
  Vec3 plain = linear(daylight_of(setup).ground);
  EXPECT_LT(glm::distance(mean, plain), 0.3f * glm::length(plain));
}

TEST(Tiles, NameBothPicturesThatTheirDrawingMakes) {
  Material m = stone({0.5f, 0.5f, 0.5f});
  Tile tile = *tile_of(m);
  EXPECT_EQ(tile_drawing(m, {}).names, (std::vector<std::string>{tile.colors, tile.normals}));
}

}  // namespace
}  // namespace frond
