#include "preset/manual.h"

#include <gtest/gtest.h>

#include "preset/json.h"

namespace frond {
namespace {

constexpr std::string_view kSchema = R"json({
  "properties": {
    "film": {"description": "The film", "type": "object", "properties": {
      "fps": {"type": "number", "minimum": 1, "maximum": 60, "description": "Frames a second", "default": 24}}},
    "organisms": {"items": {
      "properties": {"kind": {"enum": ["tree", "coral"], "description": "What it is"},
                     "place": {"description": "Where they stand", "type": "object", "properties": {
                       "lean": {"type": "number", "minimum": 0, "description": "Angle of the lean (degrees)"}}}},
      "allOf": [
        {"if": {"properties": {"kind": {"const": "tree"}}}, "then": {"properties": {"place": true, "wave": {
          "type": "object", "description": "Swaying", "properties": {
            "speed": {"type": "number", "description": "Swings in a second (1/s)", "default": 1},
            "way": {"enum": ["to", "fro"], "description": "Where it goes: far. to: thither; fro: hither"}}}}}},
        {"if": {"properties": {"kind": {"const": "coral"}}}, "then": {"properties": {"wave": {
          "type": "object", "description": "Swaying", "properties": {
            "speed": {"type": "number", "description": "Swings in a second (1/s)", "default": 2},
            "sand": {"anyOf": [{"type": "number", "exclusiveMinimum": 0}, {"type": "array", "items": {
              "type": "array", "items": [{"type": "number"}, {"type": "number"}]}}], "description": "Grains"}}}}}}]}}
  }})json";

std::vector<Topic> about(std::string_view asked) {
  return topics_about(topics_of(parse_json(kSchema, "schema")->root), asked);
}

TEST(Manual, TakesUnitsAndChoicesOffTheSentence) {
  std::vector<Topic> lean = about("organism/place/lean");
  ASSERT_EQ(lean.size(), 1u);
  EXPECT_EQ(lean[0].sentence, "Angle of the lean");
  EXPECT_EQ(lean[0].unit, "degrees");
  EXPECT_EQ(lean[0].range, "0 or more");
  std::vector<Topic> way = about("tree/wave/way");
  ASSERT_EQ(way.size(), 1u);
  EXPECT_EQ(way[0].sentence, "Where it goes: far");
  ASSERT_EQ(way[0].choices.size(), 2u);
  EXPECT_EQ(way[0].choices[0], std::pair(std::string("to"), std::string("thither")));
  EXPECT_EQ(way[0].choices[1], std::pair(std::string("fro"), std::string("hither")));
}

TEST(Manual, APathBringsAllThatIsWithin) {
  std::vector<Topic> wave = about("tree/wave");
  ASSERT_EQ(wave.size(), 3u);
  EXPECT_EQ(wave[1].path, "tree/wave/speed");
  EXPECT_EQ(wave[1].initial, "1");
  EXPECT_EQ(about("tree/wave/").size(), 3u);
}

TEST(Manual, WordsAndPathsThatAreNoneHaveANearestOne) {
  std::vector<Topic> topics = topics_of(parse_json(kSchema, "schema")->root);
  for (auto [asked, meant] : std::vector<std::pair<const char*, const char*>>{
           {"tree/wave/sped", "tree/wave/speed"},
           {"tre/wave", "tree/wave"},
           {"coral/palce/lean", "coral/place/lean"},  // what all kinds have
           {"wvae", "wave"},
           {"Wvae speed", "wave speed"},
           {"frames flim", "frames film"},
           {"wave elephant", ""},
           {"tree/elephants", ""}})
    EXPECT_EQ(nearest_topic(topics, asked), meant) << asked;
}

TEST(Manual, WhatAllKindsHaveMayBeAskedOfOne) {
  ASSERT_EQ(about("coral/place/lean").size(), 1u);
  EXPECT_EQ(about("coral/place/lean")[0].path, "organism/place/lean");
}

TEST(Manual, TheSameOfSeveralKindsIsSaidOnce) {
  std::vector<Topic> speed = about("wave/speed");
  ASSERT_EQ(speed.size(), 1u);
  EXPECT_EQ(speed[0].path, "tree, coral: wave/speed");
  EXPECT_EQ(speed[0].initial, "");  // they differ
}

TEST(Manual, FindsByWordsInNamesSentencesAndChoices) {
  ASSERT_EQ(about("Swings").size(), 1u);
  ASSERT_EQ(about("grains").size(), 1u);
  EXPECT_EQ(about("grains")[0].kind, "number or keyframes");
  EXPECT_EQ(about("grains")[0].range, "above 0");
  EXPECT_EQ(about("thither").size(), 1u);
  EXPECT_EQ(about("second swings").size(), 1u);
  EXPECT_TRUE(about("wings").empty());  // no word begins so
  EXPECT_TRUE(about("").empty());
}

TEST(Manual, TheNameThatIsAskedForLeads) {
  constexpr std::string_view kWindy = R"json({"properties": {
    "film": {"type": "object", "description": "A film of a window in the wind", "properties": {}},
    "frame": {"type": "number", "description": "Of the window"},
    "scene": {"type": "object", "description": "All else", "properties": {
      "storm": {"type": "number", "description": "How hard the wind blows"},
      "wind": {"type": "object", "description": "The air that moves", "properties": {
        "speed": {"type": "number", "description": "Metres a second"}}}}},
    "organisms": {"items": {"properties": {}, "allOf": []}}}})json";
  std::vector<std::string> paths;
  for (const Topic& topic : topics_about(topics_of(parse_json(kWindy, "schema")->root), "wind"))
    paths.push_back(topic.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"scene/wind", "scene/wind/speed", "film", "scene/storm"}));
}

TEST(Manual, AWordOfAnotherSenseIsNoSlipOfTheKeys) {
  constexpr std::string_view kLip = R"json({"properties": {
    "lip": {"type": "number", "description": "The rim"}, "center": {"type": "number", "description": "The middle"},
    "focus": {"type": "number", "description": "What is sharp"},
    "organisms": {"items": {"properties": {}, "allOf": []}}}})json";
  std::vector<Topic> topics = topics_of(parse_json(kLip, "schema")->root);
  for (const char* asked : {"tulip", "winter", "crocus"})
    EXPECT_EQ(nearest_topic(topics, asked), "") << asked;
  EXPECT_EQ(nearest_topic(topics, "centre"), "center");
  EXPECT_EQ(nearest_topic(topics, "foucs"), "focus");
}

TEST(Manual, ATopicIsTwoLines) {
  EXPECT_EQ(topic_text(about("film/fps")[0]),
            "film/fps  (number, 1 to 60; default 24)\n    Frames a second.\n");
}

}  // namespace
}  // namespace frond
