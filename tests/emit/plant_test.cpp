#include "emit/plant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include "draw/draw_list.h"
#include "emit/setting.h"
#include "emit/texts.h"
#include "motion/unfold.h"
#include "settings/settings.h"

namespace frond {
namespace {

Scene tiny_plant() { return scene_at("tests/presets/tiny_plant.json"); }

TEST(PlantText, WritesEachPartOfEachOrganOnce) {
  Scene scene = tiny_plant();
  const Specimen& herb = scene.specimens[0];
  ASSERT_GT(herb.model.organs.size(), 5u);
  std::string text;
  write_foliage({}, DrawList(herb, herb.model), 0, [&](std::string_view piece) { text += piece; });
  EXPECT_EQ(count(text, "object{Organ0_0_0 matrix<"), herb.model.organs.size());
  EXPECT_EQ(count(text, "object{Organ0_0_1 matrix<"), herb.model.organs.size());
  std::size_t faces = 0;
  for (std::size_t at = text.find("face_indices{"); at != text.npos; at = text.find("face_indices{", at + 1))
    faces += static_cast<std::size_t>(std::atoi(text.c_str() + at + 13));
  EXPECT_EQ(faces, herb.model.blades.surface.triangle.size());
}

TEST(PlantText, DeclaresWhatItUses) {
  Scene scene = tiny_plant();
  std::string text = text_of(scene, 4);
  for (std::size_t at = text.find("object{Organ"); at != text.npos; at = text.find("object{Organ", at + 1)) {
    std::string name = text.substr(at + 7, text.find(' ', at) - at - 7);
    ASSERT_NE(text.find("#declare " + name + " = mesh2{"), text.npos) << name;
  }
  // Two colours of bark, two skins.
  EXPECT_NE(text.find("#declare Skin = array[2];"), text.npos);
  EXPECT_EQ(count(text, "Plant_Bark("), 2u);
}

TEST(PlantText, OrgansWithALusterAreGlossyAboveAndMattBelow) {
  std::string leaf = R"({"symbol": "L", "luster": {"through": 0.5, "gloss": 0.3, "relief": 2}})";
  std::string picture =
      R"({"symbol": "L", "shape": "picture", "picture": {}, "luster": {"gloss": 0.3, "relief": 2}})";
  for (bool pictured : {false, true}) {
    std::string preset = R"({"seed": 2, "film": {"frames": 1}, "scene": {"setting": "studio"}, "organisms": [
      {"kind": "plant", "grammar": {"axiom": "F~L"}, "organs": [)" +
                         (pictured ? picture : leaf) + "]}]}";
    Result<Preset> read = read_preset(preset, "x", {});
    ASSERT_TRUE(read.ok());
    std::string text = text_of(*build_scene(*read), 1);
    EXPECT_EQ(count(text, pictured ? "Plant_Luster(0.35,0.3) Tree_Veined(\"leaf_"
                                   : "Plant_Luster(0.5,0.3) Plant_Veined(2)"),
              1u);
    EXPECT_EQ(
        count(text, pictured ? "Plant_Luster(0.35,0) Tree_Veined(" : "Plant_Luster(0.5,0) Plant_Veined(2)"),
        1u);
  }
  std::string yellow = R"({"seed": 2, "film": {"frames": 1}, "scene": {"setting": "studio"}, "organisms": [
    {"kind": "plant", "grammar": {"axiom": "F~L"}, "organs": [{"symbol": "L", "shape": "picture", "picture":
      {"luster": {"through": 0.4, "gloss": 0.3, "yellow": 0.5}}}]}]})";
  std::string text = text_of(*build_scene(*read_preset(yellow, "x", {})), 1);
  EXPECT_EQ(count(text, ",0.4,0.5,0.3,0)}interior_texture{Tree_Lit_Under(\"leaf_"), 1u);
  EXPECT_FALSE(read_preset(R"({"organisms": [{"kind": "plant", "grammar": {"axiom": "F~L"}, "organs":
    [{"symbol": "L", "shape": "picture"}]}]})",
                           "x", {})
                   .ok());
}

TEST(PlantText, ATreeWithoutLeavesAmongOthersThatBearThemIsWritten) {
  std::string preset = R"({"seed": 2, "film": {"frames": 1}, "scene": {"setting": "studio"}, "organisms": [
    {"kind": "weber_penn", "count": 12, "tree": {"levels": 1, "leaves": 1}}]})";
  Scene scene = *build_scene(*read_preset(preset, "x", {}));
  auto bears = [](const Specimen& b) { return b.model.organs.size() > 0; };
  ASSERT_TRUE(std::any_of(scene.specimens.begin(), scene.specimens.end(), bears));
  ASSERT_FALSE(std::all_of(scene.specimens.begin(), scene.specimens.end(), bears));
  // Whichever comes first.
  for (int turn = 0; turn < 2; ++turn) {
    EXPECT_EQ(count(text_of(scene, 1), "#declare Organ0_0_0 = mesh2{"), 1u);
    std::stable_partition(scene.specimens.begin(), scene.specimens.end(), bears);
  }
}

TEST(PlantText, HoldsNoNumberThatPovRayMisreads) {
  Scene scene = tiny_plant();
  for (int frame = 1; frame <= 4; ++frame) {
    std::string text = text_of(scene, frame);
    for (const char* bad : {"nan", "inf", "-0,", "-0>", "e-", ",>", ",}", "union{\n}"})
      EXPECT_EQ(text.find(bad), text.npos) << bad << " in frame " << frame;
  }
}

TEST(PlantText, OrgansUnfoldWithGrowth) {
  Scene scene = tiny_plant();
  std::size_t before = 0;
  for (int frame = 1; frame <= 4; ++frame) {
    std::size_t now = count(text_of(scene, frame), "object{Organ0_0_0 matrix<");
    EXPECT_GE(now, before);
    before = now;
  }
  EXPECT_EQ(count(text_of(scene, 1), "object{Organ0_0_0 matrix<"), 0u);
  EXPECT_EQ(before, scene.specimens[0].model.organs.size());
}

TEST(Unfolded, RisesFromNothingToAllWithoutAJump) {
  EXPECT_EQ(unfolded(0.4f, 0.4f, 0.3), 0);
  EXPECT_EQ(unfolded(1.0f, 1.35f, 0.35), 1);
  float last = 0;
  for (int i = 0; i <= 100; ++i) {
    float now = unfolded(0.3f, 0.013f * static_cast<float>(i), 0.35);
    EXPECT_GE(now, last);
    EXPECT_LT(now - last, 0.07f);
    last = now;
  }
}

TEST(Includes, AreThoseOfTheSetting) {
  Scene scene = tiny_plant();
  EXPECT_EQ(includes_text(scene),
            "#include \"frond_meadow.inc\"\n#include \"frond_plant.inc\"\n#include \"frond_far.inc\"");
  scene.far.reset();
  scene.setup.setting = row_of("studio");
  EXPECT_EQ(includes_text(scene), "#include \"frond_studio.inc\"\n#include \"frond_plant.inc\"");
  scene.specimens[0].look.branches.bark.reset();
  scene.setup.setting = row_of("underwater");
  EXPECT_EQ(includes_text(scene),
            "#include \"frond_water.inc\"\n#include \"frond_sand.inc\"\n#include \"frond_coral.inc\"\n"
            "#include \"frond_food.inc\"");
}

TEST(Slanted, AreThickLimbsThatAreNotUpright) {
  Specimen tree;
  tree.look.branches.bark = Bark{};
  std::int32_t top =
      tree.model.skeleton.add(Vec3(0, 1, 0), 0.2f, tree.model.skeleton.add(Vec3(0), 0.2f, -1, 0), 0);
  tree.model.skeleton.add(Vec3(1, 1.3f, 0), 0.1f, top, 1);
  tree.model.skeleton.add(Vec3(0, 1.3f, 1), 0.001f, top, 1);
  auto chunk = [](std::int32_t node) {
    Chunk c;
    c.first = c.last = node;
    return c;
  };
  DrawnBranches branches{tree, tree.model, {}};
  EXPECT_FALSE(branches.slanted(chunk(1))) << "the trunk";
  EXPECT_TRUE(branches.slanted(chunk(2))) << "a limb";
  EXPECT_FALSE(branches.slanted(chunk(3))) << "a twig";
  tree.look.branches.bark->kind = BarkKind::stem;
  EXPECT_FALSE(branches.slanted(chunk(2))) << "no pattern";
}

}  // namespace
}  // namespace frond
