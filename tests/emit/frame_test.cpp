#include "emit/frame.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/parallel.h"
#include "emit/texts.h"

namespace frond {
namespace {

TEST(Frame, IsTheSameAloneAndAtAnyThreadCount) {
  limit_threads(1);
  Scene one = scene_at("tests/presets/tiny_film.json");
  std::string text = text_of(one, 4);
  limit_threads(2);
  Scene two = scene_at("tests/presets/tiny_film.json");
  for (int frame = 1; frame <= 3; ++frame) EXPECT_NE(text_of(two, frame), text);
  EXPECT_EQ(text_of(two, 4), text);
  limit_threads(0);
}

TEST(Frame, HoldsNoNumberThatPovRayMisreads) {
  std::string text = text_of(scene_at("tests/presets/tiny_film.json"), 1) +
                     text_of(scene_at("tests/presets/tiny_film.json"), 6);
  for (const char* bad : {"nan", "inf", "-0,", "-0>", "e-", ",>", ",}"})
    EXPECT_EQ(text.find(bad), text.npos) << bad;
}

TEST(Frame, WritesANameThatCannotBreakOut) {
  Scene scene = scene_at("tests/presets/tiny_still.json");
  scene.specimens[0].name = "x\n#include \"/etc/passwd\"y\r#error \"no\"";
  std::string text = text_of(scene, 1);
  EXPECT_EQ(text.find("\n#include \"/etc"), text.npos);
  EXPECT_EQ(text.find("\r"), text.npos);
  EXPECT_EQ(text.find("\n#error"), text.npos);
}

TEST(Frame, BlursAsALensOfTheFNumberDoes) {
  Scene scene = scene_at("tests/presets/tiny_light.json");
  EXPECT_EQ(count(text_of(scene, 1), "aperture"), 0u);
  scene.stage.camera.angle = Animated<double>(degrees(2 * std::atan(0.018 / 0.05)));
  scene.stage.camera.aperture = 2;
  scene.stage.camera.focus = Animated<Vec3>(Vec3(1, 2, 3));
  std::string text = text_of(scene, 1);
  EXPECT_EQ(count(text, " aperture 0.25 focal_point<10,20,-30>"), 1u)
      << "50 mm at f/2: 25 mm, and 10 units a metre";
}

TEST(Frame, ExposesTheStudioToo) {
  Scene scene = scene_at("tests/presets/tiny_vases.json");
  ASSERT_TRUE(text_of(scene, 1).find("Studio_Setting(") != std::string::npos);
  EXPECT_EQ(count(text_of(scene, 1), "Studio_Exposure"), 0u);
  scene.stage.camera.exposure = 2;
  scene.stage.camera.highlights = 1;
  EXPECT_EQ(count(text_of(scene, 1), "#declare Studio_Exposure = 2;"), 1u) << "one stop more";
}

TEST(Frame, RefusesAHoleItDoesNotKnow) {
  Scene scene = scene_at("tests/presets/tiny_still.json");
  auto text = frame_text(scene, prepare_frames(scene), "{{frame}} {{fraem}}", 1);
  ASSERT_FALSE(text.ok());
  EXPECT_NE(text.errors()[0].text().find("fraem"), std::string::npos);
}

}  // namespace
}  // namespace frond
