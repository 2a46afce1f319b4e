#include "film/film_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "core/frame_name.h"
#include "emit/texts.h"

namespace frond {
namespace {

namespace fs = std::filesystem;

class FilmFilesTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "frond-film-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path folder_;
};

/// Files that a frame's text names and that are its own.
std::set<std::string> own_files(const std::string& text) {
  static const std::regex kName(R"(frame_\d+[a-z0-9_]*\.(rca|caustics))");
  return {std::sregex_token_iterator(text.begin(), text.end(), kName), std::sregex_token_iterator()};
}

TEST_F(FilmFilesTest, WhicheverFrameIsWrittenItsFilesLieUnderTheNamesThatItGives) {
  Scene scene = scene_at("tests/presets/tiny_film.json");
  FrameParts parts = prepare_frames(scene);
  ASSERT_TRUE(write_light(scene, parts, folder_).empty());
  ASSERT_EQ(parts.light, kOwnLight) << "it grows";
  std::string layout = *read_file(FROND_ROOT "/templates/frame.pov");
  for (int frame : {1, 3, 6}) {
    fs::path folder = folder_ / std::to_string(frame);  // nothing of another frame lies there
    ASSERT_TRUE(write_frame_file(scene, parts, layout, folder, frame));
    Result<std::string> text = read_file(folder / (frame_name(frame) + ".pov"));
    ASSERT_TRUE(text) << frame;
    EXPECT_TRUE(own_files(*text).contains(light_name(frame))) << frame;
    EXPECT_EQ(own_files(*text).size(), 2u) << "the light, and that of the waves";
    for (const std::string& name : own_files(*text)) EXPECT_TRUE(fs::exists(folder / name)) << name;
  }
}

TEST_F(FilmFilesTest, AFrameHasTheLightOfItsHour) {
  Result<Preset> preset = read_preset(*read_file(FROND_ROOT "/tests/presets/tiny_garden.json"), "tiny.json",
                                      {"/film/frames=3", "/scene/garden/hour=[[0, 6], [0.08, 13]]"});
  ASSERT_TRUE(preset);
  Scene scene = *build_scene(*preset);
  FrameParts parts = prepare_frames(scene);
  ASSERT_TRUE(write_light(scene, parts, folder_).empty());
  ASSERT_EQ(parts.light, kOwnLight) << "the sun moves";
  std::string layout = *read_file(FROND_ROOT "/templates/frame.pov");
  std::set<std::string> skies, lights;
  for (int frame : {1, 3}) {
    ASSERT_TRUE(write_frame_file(scene, parts, layout, folder_, frame));
    std::string text = *read_file(folder_ / (frame_name(frame) + ".pov"));
    skies.insert(text.substr(text.find("Sky_Clear"), 400));
    lights.insert(*read_file(folder_ / light_name(frame)));
  }
  EXPECT_EQ(skies.size(), 2u);
  EXPECT_EQ(lights.size(), 2u);
}

TEST_F(FilmFilesTest, ExposuresShareTheLightOfTheirFrame) {
  Scene scene = scene_at("tests/presets/tiny_film.json");
  scene.setup.camera.shutter = 0.5;
  scene.setup.camera.shutter_samples = 2;
  FrameParts parts = prepare_frames(scene);
  ASSERT_TRUE(write_light(scene, parts, folder_).empty());
  std::string layout = *read_file(FROND_ROOT "/templates/frame.pov");
  for (int exposure : {1, 2}) {
    ASSERT_TRUE(write_frame_file(scene, parts, layout, folder_, 2, exposure));
    Result<std::string> text = read_file(folder_ / (exposure_name(2, exposure) + ".pov"));
    ASSERT_TRUE(text) << exposure;
    for (const std::string& name : own_files(*text)) EXPECT_TRUE(fs::exists(folder_ / name)) << name;
  }
  EXPECT_TRUE(fs::exists(folder_ / light_name(2)));
}

}  // namespace
}  // namespace frond
