#include "scene/remarks.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace frond {
namespace {

std::vector<std::string> notes_of_studio(const std::string& studio, const std::string& camera = "") {
  std::string text =
      R"({"film": {"frames": 1}, "scene": {"setting": "studio", "studio": {)" + studio + "}" + camera +
      R"(}, "organisms": [{"kind": "column", "name": "mast", "height": 12, "radius": 0.4, "place":
                       {"at": [[0, 0]], "lean": 0, "size_variation": 0}}]})";
  return build_scene(*read_preset(text, "x", {}))->notes;
}

TEST(Studio, WhatGoesThroughItsWallIsNoted) {
  std::vector<std::string> notes = notes_of_studio(R"("distance": 0.3)");
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("mast: reaches"), std::string::npos);
  EXPECT_NE(notes[0].find("through the studio's wall; studio.distance"), std::string::npos);
  EXPECT_TRUE(notes_of_studio(R"("distance": 3)").empty());
}

TEST(Studio, WhatStandsRoundItsLampIsNoted) {
  std::vector<std::string> notes = notes_of_studio(
      R"("distance": 3, "key": [0, 1, 0])", R"(, "camera": {"location": [0, 1, 2], "look_at": [0, 1, 0]})");
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("mast: the studio's main light hangs within it"), std::string::npos);
}

}  // namespace
}  // namespace frond
