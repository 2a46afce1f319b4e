#include "scene/unused_properties.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/files.h"
#include "preset/json.h"
#include "preset/manual.h"
#include "scene/scene.h"

namespace frond {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> notes_of(const std::string& text, const std::vector<std::string>& sets = {}) {
  Result<Preset> preset = read_preset(text, "p.json", sets);
  if (!preset) return {preset.errors().front().text()};
  std::vector<std::string> notes;
  for (const Error& note : preset->notes) notes.push_back(note.text());
  return notes;
}

using Notes = std::vector<std::string>;

TEST(UnusedProperties, OfAnotherSurroundingAreNoted) {
  EXPECT_EQ(
      notes_of(R"({"scene": {"setting": "meadow",
 "water": {"visibility": 4}, "floor": {"relief": 0.1,
 "stones": 7}, "meadow": {"blade": 0.1}}})"),
      (Notes{"p.json:2:11: /scene/water: does nothing here: the setting is meadow; it is for underwater",
             "p.json:3:12: /scene/floor/stones: does nothing here: the setting is meadow; it is for "
             "underwater"}));
  EXPECT_EQ(
      notes_of(R"({"scene": {"forest": {"moss": 1}, "meadow": {"sun": [0, 1, 0]}}})"),
      (Notes{"p.json:1:22: /scene/forest: does nothing here: the setting is underwater; it is for forest",
             "p.json:1:45: /scene/meadow: does nothing here: the setting is underwater; it is for meadow, "
             "garden, forest"}))
      << "the whole is told of, not its parts";
  EXPECT_EQ(
      notes_of(R"({"scene": {"setting": "garden", "meadow": {"sun": [0, 1, 0], "clouds": 0}}})"),
      (Notes{"p.json:1:51: /scene/meadow/sun: does nothing here: the setting is garden; it is for meadow"}));
}

TEST(UnusedProperties, HeatWithoutAReefIsNoted) {
  EXPECT_EQ(notes_of(R"({"events": [{"year": 3, "heat": 8}], "organisms": [{"kind": "tree"}]})"),
            (Notes{"p.json:1:33: /events/0/heat: does nothing here: it is for a preset with a reef"}));
  EXPECT_EQ(notes_of(R"({"events": [{"year": 3, "heat": 8}], "reef": {}, "organisms": []})"), Notes{});
}

TEST(UnusedProperties, OfAnOrganismAreNoted) {
  EXPECT_EQ(
      notes_of(R"({"scene": {"setting": "studio"}, "organisms": [
 {"kind": "coral", "place": {"rock": 0.4}}, {"kind": "coral", "place": {"rock": 0}},
 {"kind": "coral", "wave": {"speed": 2}, "food": {"position": [0, 1, 0]}},
 {"kind": "tree", "sown": {}, "place": {"radius": 3, "lean": 0}}]})"),
      (Notes{"p.json:2:38: /organisms/0/place/rock: does nothing here: rocks lie under water only",
             "p.json:3:28: /organisms/2/wave: does nothing here: its amplitude is not given and so is 0",
             "p.json:3:50: /organisms/2/food: does nothing here: its strength is not given and so is 0",
             "p.json:4:51: /organisms/3/place/radius: does nothing here: sown.where says where copies "
             "stand"}));
}

TEST(UnusedProperties, HowToDrawBranchesThatThereAreNotIsNoted) {
  EXPECT_EQ(
      notes_of(R"({"scene": {"setting": "forest"}, "organisms": [
 {"kind": "table", "body": "fused"}, {"kind": "coral", "body": "fused"}, {"kind": "rock", "body": {"voxel": 0.1}},
 {"kind": "tree", "sown": {}, "body": "voxels"},
 {"kind": "coral", "body": {"blend": 2}}, {"kind": "coral", "body": {"build": "voxels", "voxel": 0.1, "blend": 2}}]})"),
      (Notes{"p.json:2:28: /organisms/0/body: does nothing here: this kind has no branches, which it is for",
             "p.json:2:99: /organisms/2/body: does nothing here: this kind has no branches, which it is for",
             "p.json:3:39: /organisms/3/body: does nothing here: copies that are sown are drawn branch by "
             "branch",
             "p.json:4:38: /organisms/4/body/blend: does nothing here: it needs \"build\": \"fused\" or "
             "\"rough\"",
             "p.json:4:112: /organisms/5/body/blend: does nothing here: it needs \"build\": \"fused\" or "
             "\"rough\""}));
  // A whole reef may be fused, whatever stands among it.
  EXPECT_EQ(
      notes_of(R"({"defaults": {"body": "fused"}, "organisms": [{"kind": "table"}, {"kind": "coral"}]})"),
      Notes{});
}

TEST(UnusedProperties, WhatNeedsAnotherPropertyIsNoted) {
  EXPECT_EQ(
      notes_of(R"({"scene": {"setting": "meadow"}, "organisms": [
 {"kind": "rock", "weathering": {"dip": 20}}, {"kind": "rock", "weathering": {"dip": 20, "strata": 0.5}},
 {"kind": "bridge", "style": "stone", "balusters": 3}, {"kind": "bridge", "balusters": 3},
 {"kind": "tree", "light": {"depth": 3}}, {"kind": "tree", "light": {"depth": 3, "fading": "even"}}]})"),
      (Notes{
          "p.json:2:41: /organisms/0/weathering/dip: does nothing here: it needs strata above 0",
          "p.json:3:52: /organisms/2/balusters: does nothing here: it needs \"style\": \"wood\"",
          "p.json:4:38: /organisms/4/light/depth: does nothing here: it needs fading other than diffuse"}));
}

/// What a sentence says that a property needs is what is looked at.
TEST(UnusedProperties, SentencesOfNeedsAreUnderstood) {
  int count = 0;
  for (const Topic& topic : topics_of(preset_schema())) {
    std::size_t at = topic.sentence.find("Needs ");
    std::string_view said = std::string_view(topic.sentence).substr(std::min(at, topic.sentence.size()));
    // What is there or not, and no value, is told of by the kinds themselves.
    if (said.empty() || said == "Needs a coat" || said == "Needs photo") continue;
    std::optional<Need> need = need_of(topic.sentence);
    ASSERT_TRUE(need) << topic.path << ": " << topic.sentence;
    EXPECT_FALSE(need->name.empty() || need->name.find(' ') != std::string::npos) << topic.sentence;
    ++count;
  }
  EXPECT_GT(count, 25);
}

TEST(UnusedProperties, AStrengthInRadiansIsNoted) {
  EXPECT_EQ(
      notes_of(
          R"({"defaults": {"food": {"strength": 0.8}}, "organisms": [{"kind": "coral"}, {"kind": "coral"}]})"),
      (Notes{
          "p.json:1:36: /organisms/0/food/strength: is an angle in degrees; 0.8 radians would be 45.8366"}));
  EXPECT_EQ(notes_of(R"({"organisms": [{"kind": "coral", "food": {"strength": 20}}]})"), Notes{});
}

TEST(UnusedProperties, DefaultsAndOverridesAreNoFalseAlarm) {
  EXPECT_EQ(
      notes_of(
          R"({"scene": {"setting": "studio"}, "defaults": {"place": {"rock": 0.4}, "wave": {"amplitude": 9}},
 "organisms": [{"kind": "coral", "wave": {"speed": 2}}]})"),
      Notes{});
  const std::string reef = R"({"scene": {"water": {"shafts": 0}}, "organisms": []})";
  EXPECT_EQ(notes_of(reef, {"/scene/setting=studio"}), Notes{});
  EXPECT_EQ(notes_of(reef, {"/scene/setting=studio", "/scene/water/caustics=0"}), Notes{});
  EXPECT_EQ(
      notes_of(reef, {"/scene/studio/distance=2"}),
      (Notes{"--set /scene/studio/distance: /scene/studio: does nothing here: the setting is underwater; it "
             "is for studio"}));
}

TEST(UnusedProperties, NoneInThePresetsThatAreShipped) {
  int count = 0;
  for (const char* folder : {"/presets", "/tests/presets"}) {
    for (const auto& file : fs::recursive_directory_iterator(std::string(FROND_ROOT) + folder)) {
      if (file.path().extension() != ".json") continue;
      std::string text = *read_file(file.path());
      if (text.find("\"organisms\"") == text.npos && text.find("\"base\"") == text.npos) continue;
      Result<Preset> preset = read_preset(text, file.path().string(), {});
      ASSERT_TRUE(preset.ok()) << preset.errors().front().text();
      for (const Error& note : preset->notes) ADD_FAILURE() << note.text();
      ++count;
    }
  }
  EXPECT_GT(count, 60);
}

TEST(Camera, UnderTheGroundIsNoted) {
  auto notes = [](const std::string& camera) {
    Result<Preset> preset = read_preset(R"({"film": {"frames": 25}, "scene": {"setting": "studio",
 "camera": {"location": )" + camera + R"(}}, "organisms": []})",
                                        "p.json", {});
    return build_scene(*preset)->notes;
  };
  EXPECT_EQ(notes("[0, 0.5, 4]"), Notes{});
  EXPECT_EQ(
      notes("[0, -0.5, 4]"),
      (Notes{"p.json:2:25: /scene/camera/location: lies up to 0.5 m under the ground, first at 0 s: nothing "
             "is seen from there"}));
  EXPECT_EQ(notes("[[0, [0, 1, 4]], [0.5, [0, 1, 4]], [1, [0, -0.25, 4]]]").size(), 1u);
}

}  // namespace
}  // namespace frond
