#include "render/scene_head.h"

#include <gtest/gtest.h>

namespace frond {

TEST(SceneHead, IsPlainWhereNothingIsSaid) {
  SceneHead head = read_scene_head(
      "// povray +W64 +H48\n// +RFlight_1.rca +FN16; then frond develop --highlights 1 --contrast 1\n");
  EXPECT_EQ(head.light, "");
  EXPECT_FALSE(head.fine);
  EXPECT_EQ(head.exposures, 1);
}

TEST(SceneHead, NamesTheLight) {
  EXPECT_EQ(read_scene_head("// povray +RFI +RFlight_01ab.rca +W64\n").light, "light_01ab.rca");
  EXPECT_EQ(read_scene_head("// +RFframe_0001.rca").light, "frame_0001.rca");
  for (const char* odd : {"// +RF../light.rca", "// +RF/light.rca", "// +RF.rca", "// +RFlight", "// +RFI"})
    EXPECT_EQ(read_scene_head(odd).light, "") << odd;
}

TEST(SceneHead, SaysHowThePictureIsDeveloped) {
  SceneHead head =
      read_scene_head("// +A +FN16; then frond develop --highlights 1.5 --contrast 1.1\n#version");
  EXPECT_TRUE(head.fine);
  EXPECT_EQ(head.exposures, 1);
  EXPECT_EQ(head.tone.highlights, 1.5);
  EXPECT_EQ(head.tone.contrast, 1.1);
  head = read_scene_head(
      "// +FN16; then frond develop --highlights 2 --contrast 1 --saturation 0.85 --vignette 0.15 --depth "
      "16");
  EXPECT_TRUE(head.fine);
  EXPECT_EQ(head.tone.saturation, 0.85);
  EXPECT_EQ(head.tone.warmth, 0);
  EXPECT_EQ(head.tone.vignette, 0.15);
  EXPECT_EQ(head.depth, 16);
  head = read_scene_head("// +FN16; exposure 1 of 8; then frond develop --highlights 0 --contrast 1");
  EXPECT_TRUE(head.fine);
  EXPECT_EQ(head.exposures, 8);
}

TEST(SceneHead, SaysThatThePictureIsRaw) {
  SceneHead head = read_scene_head("// +RFlight_1.rca +FN16; then frond resolve\n#version");
  EXPECT_TRUE(head.fine);
  EXPECT_TRUE(head.raw);
  EXPECT_EQ(head.light, "light_1.rca");
  EXPECT_FALSE(read_scene_head("// +FN16; then frond resolve it").fine);
  EXPECT_TRUE(read_scene_head("// +FN16; then frond resolve, with air: visibility 9 m at 0 m").raw);
}

TEST(SceneHead, SaysWhichPartIsDrawnAndHowItIsWritten) {
  SceneHead head =
      read_scene_head("// +W96 file.pov +SC33 +EC96 +SR1 +ER64 (of which 37,21,33x30) +UA +FN16\n#version");
  EXPECT_TRUE(head.alpha);
  EXPECT_TRUE(head.fine && head.raw);
  EXPECT_EQ(head.crop, (std::array{37, 21, 33, 30}));
  EXPECT_EQ(head.part, (std::vector<std::string>{"+SC33", "+EC96", "+SR1", "+ER64"}));
  head = read_scene_head("// +UA +FN16; then frond develop --highlights 1 --contrast 1 --depth 16\n");
  EXPECT_TRUE(head.alpha && head.fine && !head.raw);
  EXPECT_EQ(head.depth, 16);
  head = read_scene_head("// file.pov +SC33 +EC96 (of which 1,2,3)");
  EXPECT_EQ(head.crop[2], 0);
  EXPECT_TRUE(head.part.empty());
}

TEST(SceneHead, TakesNothingElseForIt) {
  for (const char* odd :
       {"// +FN16; exposure 2 of 8", "// +FN16; then frond develop --highlights x --contrast 1",
        "// +FN16; then frond develop --highlights 1 --contrast 1; rm",
        "// +FN16; then frond develop --highlights 1 --contrast 1 --warmth x"}) {
    EXPECT_FALSE(read_scene_head(odd).fine) << odd;
    EXPECT_EQ(read_scene_head(odd).exposures, 1) << odd;
  }
}

}  // namespace frond
