#include "appearance/appearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "appearance/skin_colors.h"
#include "core/linear.h"

namespace frond {
namespace {

double light_of(const Color& c) {
  Vec3 light = linear(c);
  return 0.2126 * light.x + 0.7152 * light.y + 0.0722 * light.z;
}

TEST(BranchLook, TipsOfCoralsArePalerByHowYoungTheyAre) {
  BranchLook look{.skin = Skin{}};
  double before = light_of(look.plain(0, 1));
  for (double young : {0.2, 0.6, 1.0}) {
    look.skin->tint.young = young;
    double tip = light_of(look.young(0, 1, Built::branches));
    EXPECT_GT(tip, before) << young;
    before = tip;
  }
}

TEST(BranchLook, BrightnessIsAFactor) {
  BranchLook bark{.bark = Bark{}};
  EXPECT_NEAR(bark.plain(0, 0.5).red, 0.5 * bark.plain(0, 1).red, 1e-6);
  BranchLook skin{.skin = Skin{}};
  EXPECT_NEAR(light_of(skin.plain(0, 0.5)), 0.5 * light_of(skin.plain(0, 1)), 1e-6) << "of its light";
}

TEST(BranchLook, ChoosesTheTurtlesColourCyclically) {
  BranchLook look{.bark = Bark{}};
  look.bark->colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Model model;
  EXPECT_EQ(look.color_at(model, 0), 0u) << "without colours all have the first";
  model.color = {0, 1, 5, -1};
  EXPECT_EQ(look.color_at(model, 1), 1u);
  EXPECT_EQ(look.color_at(model, 2), 2u);
  EXPECT_EQ(look.color_at(model, 3), 2u);
}

TEST(BranchLook, OnlyWhatHasAPatternHasASizeOfIt) {
  BranchLook look{.bark = Bark{}};
  for (BarkKind kind : {BarkKind::bark, BarkKind::birch, BarkKind::stem, BarkKind::ink, BarkKind::metal,
                        BarkKind::wax, BarkKind::palm}) {
    look.bark->kind = kind;
    EXPECT_EQ(look.patterned(), look.pattern_size() > 0) << static_cast<int>(kind);
    EXPECT_EQ(look.ringed(), kind == BarkKind::palm);
  }
  EXPECT_FALSE(BranchLook{}.drawn());
  EXPECT_EQ(BranchLook{}.pattern_size(), 0);
}

TEST(Tinted, TurnsTheHueRoundGreyAndKeepsGrey) {
  Tint tint;
  tint.course.hue = 120.0;
  Vec3 grey = tinted(Color{0.5f, 0.5f, 0.5f}, tint);
  EXPECT_NEAR(grey.x, grey.y, 1e-5);
  EXPECT_NEAR(grey.x, linear(Color{0.5f, 0.5f, 0.5f}).x, 1e-5);
  Vec3 turned = tinted(Color{0.8f, 0.1f, 0.1f}, tint);
  EXPECT_GT(turned.y, 5 * turned.x) << "a third of a turn takes red to green";
  tint.course.hue = 0.0, tint.course.saturation = 0.0;
  Vec3 faded = tinted(Color{0.8f, 0.1f, 0.1f}, tint);
  EXPECT_NEAR(faded.x, faded.z, 1e-5);
}

TEST(Mean, IsOfLightAndNotOfNumbers) {
  Vec3 half = mean({{0, 0, 0}, {1, 1, 1}});
  EXPECT_NEAR(half.x, 0.5, 1e-6);
  EXPECT_GT(mean({}).x, 0);
}

TEST(Drawings, AreOfAllThatShowsPictures) {
  Look look;
  EXPECT_TRUE(drawings(look).empty());
  look.leaves = LeafLook{};
  std::size_t leaves = drawings(look).size();
  EXPECT_EQ(leaves, look.leaves->looks()) << "one for each colour";
  look.branches.bark = Bark{};
  look.branches.coat = BarkCoat{};
  std::vector<Drawing> all = drawings(look);
  EXPECT_EQ(all.size(), leaves + 1);
  EXPECT_EQ(all.back().names.front(), bark_color_name(*look.branches.coat));
}

TEST(Leaves, HaveOtherSprigsAtTheEndsOfBranches) {
  LeafLook look;
  look.end_sprigs = true;
  EXPECT_EQ(leaf_prototypes(look).size(), 1u) << "single leaves have no ends";
  look.sprig = true;
  std::vector<Prototype> both = leaf_prototypes(look);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_GT(both[0].parts[0].surface.triangle.size(), both[1].parts[0].surface.triangle.size());
  // Each has its own pictures, which are drawn and known by their names.
  std::set<std::string> drawn;
  for (const Drawing& drawing : leaf_drawings(look)) drawn.insert(drawing.names.begin(), drawing.names.end());
  EXPECT_EQ(drawn.size(), 2 * look.looks());
  for (const Prototype& p : both)
    for (const std::string& picture : p.parts[0].pictures) {
      EXPECT_TRUE(drawn.contains(picture));
      EXPECT_EQ(shown_in(look, picture).sprigs.end_leaf, &p == &both[0]);
    }
  look.sprigs.end_leaf = false;
  EXPECT_EQ(leaf_prototypes(look).size(), 1u) << "none has a leaf at its tip";
}

TEST(Leaves, HaveStalksAsLongAsAsked) {
  LeafLook look;
  double usual = leaf_image(look, 0).outline.stalk;
  look.stalk = 0.5;
  EXPECT_DOUBLE_EQ(leaf_image(look, 0).outline.stalk, 0.5);
  // The blade begins where the stalk ends.
  std::vector<Vec2> rim = leaf_rim(leaf_image(look, 0).outline, 12);
  EXPECT_GT(std::ranges::min(rim, {}, &Vec2::y).y, 0.4f);
  EXPECT_LT(usual, 0.4);
}

}  // namespace
}  // namespace frond
