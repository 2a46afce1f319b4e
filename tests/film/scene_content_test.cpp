#include "film/scene_content.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/files.h"
#include "images/raster.h"

namespace frond {
namespace {

namespace fs = std::filesystem;

class SceneContentTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "frond-content-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// A folder with a scene of two models, of which one names a block of its own and a picture, and soft
  /// light.
  fs::path scene(const std::string& one, const std::string& two, const std::string& height = "2") {
    fs::path folder = folder_ / (one + two + height);
    auto write = [&](const std::string& file, const std::string& text) {
      ASSERT_TRUE(write_file(folder / file, text).ok());
    };
    Raster bark(2, 2, 1);
    bark.data = {1, 2, 3, 4};
    write("bark_" + two + ".png", *png_text(bark));
    write("light_" + one + ".rca", "0.1 0.2\n");
    write("model_" + one + "_4.inc", "// of leaves\n#declare Model_" + one + "_4 = sphere{0,1}\n");
    write("model_" + two + "_4_0.inc", "cone{0,1,y*" + height + ",0}\n");
    write("model_" + two + "_4.inc",
          "#include \"model_" + two + "_4_0.inc\"\npng \"bark_" + two + ".png\"\n");
    std::string head = "// Frame 3 of 9. Render with: povray +RFI +RFlight_" + one + ".rca +W64 +H36\n";
    // The order of these follows their names.
    std::string first = "#include \"model_" + std::min(one, two) + "_4.inc\"\n";
    write("frame_0003.pov", head + first + "#include \"model_" + std::max(one, two) +
                                "_4.inc\"\nobject{Model_" + one + "_4 texture{Plant_Leaf(1)}}\n");
    return folder;
  }
  static std::string id_of(const fs::path& folder) {
    Result<SceneContent> content = scene_content(folder, {"frame_0003.pov"});
    EXPECT_TRUE(content.ok());
    return content ? content->id : "";
  }

  const std::string a_ = "00112233445566aa", b_ = "ff112233445566bb", c_ = "99112233445566cc";
  fs::path folder_;
};

TEST_F(SceneContentTest, NamesByContentDoNotMakeASceneAnother) {
  std::string id = id_of(scene(a_, b_));
  EXPECT_EQ(id.size(), 16u);
  EXPECT_EQ(id_of(scene(c_, b_)), id);
  EXPECT_EQ(id_of(scene(b_, a_)), id) << "in another order, too";
}

TEST_F(SceneContentTest, WhatASceneIsMadeOfMakesItAnother) {
  std::string id = id_of(scene(a_, b_));
  EXPECT_NE(id_of(scene(a_, b_, "3")), id) << "a block of a model that it names";
  fs::path folder = scene(a_, b_);
  ASSERT_TRUE(write_file(folder / ("light_" + a_ + ".rca"), "0.1 0.3\n").ok());
  EXPECT_NE(id_of(folder), id);
  ASSERT_TRUE(write_file(folder / ("light_" + a_ + ".rca"), "0.1 0.2\n").ok());
  EXPECT_EQ(id_of(folder), id);
  Raster bark(2, 2, 1);
  bark.data = {1, 2, 3, 5};
  ASSERT_TRUE(write_file(folder / ("bark_" + b_ + ".png"), *png_text(bark)).ok());
  EXPECT_NE(id_of(folder), id);
}

TEST_F(SceneContentTest, CommentsAndWhatLiesBesideDoNotMakeASceneAnother) {
  fs::path folder = scene(a_, b_);
  std::string id = id_of(folder);
  ASSERT_TRUE(write_file(folder / ("model_" + c_ + "_4.inc"), "box{0,1}\n").ok());
  std::string model = *read_file(folder / ("model_" + a_ + "_4.inc"));
  ASSERT_TRUE(write_file(folder / ("model_" + a_ + "_4.inc"), "// of 12 leaves" + model.substr(12)).ok());
  EXPECT_EQ(id_of(folder), id);
}

TEST_F(SceneContentTest, WordsAreThoseThatMacrosMayBeAmong) {
  Result<SceneContent> content = scene_content(scene(a_, b_), {"frame_0003.pov"});
  ASSERT_TRUE(content.ok());
  EXPECT_TRUE(content->words.contains("Plant_Leaf"));
  EXPECT_FALSE(content->words.contains("sphere"));
  EXPECT_FALSE(scene_content(folder_, {"none.pov"}).ok());
}

}  // namespace
}  // namespace frond
