#include "gallery/gallery_list.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/files.h"

namespace frond {

TEST(GalleryList, NamesPicturesAndTheirParts) {
  Result<GalleryList> list = read_gallery(
      "# a note\nlarge: reef oak\n\nreef 800x450 1 reef@96\n"
      "ages 320x300 3 trees/oak,/organisms/0/years=8,/scene/camera/fit=[\"all\"] trees/oak\n",
      "list");
  ASSERT_TRUE(list);
  EXPECT_EQ(list->large, (std::vector<std::string>{"reef", "oak"}));
  ASSERT_EQ(list->pictures.size(), 2u);
  const GalleryPicture &reef = list->pictures[0], &ages = list->pictures[1];
  EXPECT_EQ(reef.name, "reef");
  EXPECT_EQ(reef.size, (std::array{800, 450}));
  ASSERT_EQ(reef.parts.size(), 1u);
  EXPECT_EQ(reef.parts[0].preset, "reef");
  EXPECT_EQ(reef.parts[0].frame, 96);
  EXPECT_EQ(ages.columns, 3);
  ASSERT_EQ(ages.parts.size(), 2u);
  EXPECT_EQ(ages.parts[0].sets,
            (std::vector<std::string>{"/organisms/0/years=8", "/scene/camera/fit=[\"all\"]"}));
  EXPECT_EQ(ages.parts[1].frame, 1);
}

TEST(GalleryList, TellsTheLineThatIsNone) {
  for (const char* line :
       {"reef", "reef 800x450 1", "reef 800 1 reef", "reef 800x450 0 reef", "reef 8x4 1 reef@x"}) {
    Result<GalleryList> list = read_gallery(std::string("# a note\n") + line, "list");
    ASSERT_FALSE(list) << line;
    EXPECT_EQ(list.errors()[0].where, "list:2") << line;
  }
}

TEST(GalleryList, OfFrondHoldsItsLargePictures) {
  Result<std::string> text = read_file(FROND_ROOT "/docs/gallery/pictures.txt");
  ASSERT_TRUE(text);
  Result<GalleryList> list = read_gallery(*text, "pictures.txt");
  ASSERT_TRUE(list);
  EXPECT_FALSE(list->large.empty());
  for (const std::string& name : list->large) {
    auto picture = std::ranges::find(list->pictures, name, &GalleryPicture::name);
    ASSERT_NE(picture, list->pictures.end()) << name;
    EXPECT_EQ(picture->columns, 1) << name;
  }
}

TEST(GalleryList, LargePicturesAreOfTheSameShape) {
  EXPECT_EQ(large_size({800, 450}), (std::array{1280, 720}));
  EXPECT_EQ(large_size({640, 507}), (std::array{1280, 1014}));
}

TEST(GalleryPage, ARowNamesEachPresetOnceAndRoundsSeconds) {
  GalleryPicture picture{
      "ages", {320, 300}, 3, {{"trees/oak", 1, {}}, {"trees/oak", 9, {}}, {"reef", 1, {}}}};
  EXPECT_EQ(gallery_row(picture, {7, 120, 12.5}, ""),
            R"(| <img src="gallery/ages.jpg" width="200"> | presets/trees/oak.json, presets/reef.json )"
            "| 320x300 | 7 | 120 | 13 |");
}

TEST(GalleryPage, ARowKeepsTheSecondsThatItHad) {
  GalleryPicture picture{"bush-1.25", {4, 3}, 1, {{"bush", 1, {}}}};
  GalleryRow row{1, 5, 42.0};
  std::string page = gallery_page({gallery_row(picture, row, "")});
  row.seconds.reset();
  EXPECT_TRUE(gallery_row(picture, row, page).ends_with("| 5 | 42 |"));
  EXPECT_TRUE(gallery_row(picture, row, "").ends_with("| 5 | ? |"));
  EXPECT_EQ(row_on_page(page, "bush-1x25"), "");
}

TEST(GalleryPage, APictureLeadsToItsLargeOneOnce) {
  GalleryPicture picture{"reef", {4, 3}, 1, {{"reef", 1, {}}}};
  std::string row = row_with_large(gallery_row(picture, {1, 5, 42.0}, ""), "reef");
  EXPECT_TRUE(row.starts_with(
      R"(| <a href="gallery/large/reef.jpg"><img src="gallery/reef.jpg" width="200"></a> | )"))
      << row;
  EXPECT_EQ(row_with_large(row, "reef"), row);
  EXPECT_EQ(row_on_page(gallery_page({row}), "reef"), row);
}

TEST(ExampleScene, SaysHowItIsMade) {
  ExampleScene example = read_example(
      "// A palm. First, once:\n//   frond export presets/palm.json -o palm.inc\n//   frond export b.json  "
      "-o b.inc\n"
      "// Then: povray +Iterrace.pov +W800 +H500 +A\n#version 3.7;\n");
  ASSERT_EQ(example.calls.size(), 2u);
  EXPECT_EQ(example.calls[0], (std::vector<std::string>{"export", "presets/palm.json", "-o", "palm.inc"}));
  EXPECT_EQ(example.calls[1].back(), "b.inc");
  EXPECT_EQ(example.size, (std::array{800, 500}));
}

TEST(GrammarPreset, HoldsTheGrammarAndWhatItPlaces) {
  std::string layout = "{\n@organs@\n\"grammar\":\n@grammar@\n}\n";
  EXPECT_EQ(grammar_preset(layout, "{\"axiom\": \"F\"}\n"), "{\n\"grammar\":\n{\"axiom\": \"F\"}\n}\n");
  EXPECT_NE(grammar_preset(layout, "{\"axiom\": \"~b\"}\n").find("\"shape\": \"bud\""), std::string::npos);
  EXPECT_NE(grammar_preset(layout, "{\"axiom\": \"~L\"}\n").find("[{\"symbol\": \"L\""), std::string::npos);
}

TEST(Gallery, HashesOfScenesAreReadAsTheyWereWritten) {
  SceneIds ids{{"large/reef", "0123456789abcdef"}, {"reef", "fedcba9876543210"}};
  EXPECT_EQ(read_scene_ids(scene_ids_text(ids)), ids);
  EXPECT_EQ(read_scene_ids("# a note\nreef\nreef 1 2\n\nfan 0f\n"), (SceneIds{{"fan", "0f"}}));
}

}  // namespace frond
