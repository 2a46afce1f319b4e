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

TEST(Frame, BranchesInShadeDieWhenTheirNeighboursHaveGrown) {
  Scene scene = scene_at("tests/presets/tiny_film.json");
  for (Specimen& s : scene.specimens) s.model.light.clear();
  EXPECT_EQ(count(text_of(scene, 6), "Coral_Starv"), 0u);
  scene.specimens[0].model.light.assign(scene.specimens[0].model.skeleton.size(), 0.2f);
  EXPECT_EQ(count(text_of(scene, 2), "Coral_Starved("), 0u) << "they are small yet";
  std::string grown = text_of(scene, 6);
  EXPECT_EQ(count(grown, "Coral_Starving("), 1u);
  EXPECT_GT(count(grown, "Coral_Starved(0,"), 3u);
  EXPECT_EQ(count(grown, "Coral_Starved(1,"), 0u) << "the other has all of its light";
}

TEST(Frame, BranchesTooThinToShowAPatternShareTextures) {
  Scene scene = scene_at("tests/presets/tiny_film.json");
  std::string fine = text_of(scene, 6);
  scene.film.size = {16, 9};
  std::string coarse = text_of(scene, 6);
  EXPECT_LT(count(coarse, "matrix<"), count(fine, "matrix<") / 4);
  EXPECT_LT(count(coarse, "Coral_Tip("), 30u);
  EXPECT_GT(count(coarse, "Coral_Tip(0,0,0,0,"), 0u) << "tips are young yet";
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
  scene.setup.camera.angle = Animated<double>(degrees(2 * std::atan(0.018 / 0.05)));
  scene.setup.camera.aperture = 2;
  scene.setup.camera.focus = Focus{Animated<Vec3>(Vec3(1, 2, 3)), ""};
  std::string text = text_of(scene, 1);
  EXPECT_EQ(count(text, " aperture 0.5 focal_point<10,20,-30>"), 1u)
      << "50 mm at f/2: 25 mm, 10 units a metre, and twice that, since rays start within half of it";
}

TEST(Frame, ExposuresLieWithinTheTimeOfTheShutter) {
  Scene scene = scene_at("tests/presets/tiny_film.json");
  const Film& film = scene.film;
  Camera& camera = scene.setup.camera;
  const std::string layout = "{{file}} {{time}}{{tone}}|{{camera}}{{organisms}}";
  FrameParts parts = prepare_frames(scene);
  auto exposed = [&](int frame, int exposure) {
    std::string text;
    EXPECT_TRUE(write_frame(
        scene, parts, layout, frame, [&](std::string_view some) { text += some; }, exposure));
    return text;
  };
  std::string sharp = exposed(3, 0);
  EXPECT_EQ(exposed(3, 1), sharp) << "with no shutter the only exposure is the frame";
  camera.shutter = 0.5;
  EXPECT_EQ(exposures(film, camera), 1) << "in a draft";
  EXPECT_EQ(exposed(3, 1), sharp);
  camera.shutter_samples = 4;
  EXPECT_EQ(exposures(film, camera), 4);
  EXPECT_EQ(exposed(3, 0), sharp) << "the frame at its own time, whatever the shutter";
  double frame_time = 1 / film.fps, before = film.time(3);
  for (int i = 1; i <= 4; ++i) {
    double time = exposure_time(film, camera, 3, i);
    EXPECT_NEAR(time - before, i == 1 ? frame_time / 16 : frame_time / 8, 1e-9) << "evenly spread";
    before = time;
  }
  EXPECT_LT(before, film.time(3) + 0.5 * frame_time);
  EXPECT_LT(exposure_time(film, camera, film.frames, 4), film.length()) << "never past the end of the film";
  EXPECT_NE(exposed(3, 2).find("frame_0003_s2.pov "), std::string::npos);
  EXPECT_NE(
      exposed(3, 1).find(
          "frame_0003.pov 0.34375 +FN16; exposure 1 of 4; then frond develop --highlights 0 --contrast 1|"),
      std::string::npos)
      << exposed(3, 1).substr(0, 120);
  EXPECT_NE(exposed(3, 4).find(" +FN16; exposure 4 of 4|"), std::string::npos);
  EXPECT_NE(exposed(3, 1).substr(exposed(3, 1).find('|')), exposed(3, 2).substr(exposed(3, 2).find('|')));
  scene.film.frames = 1;
  EXPECT_EQ(exposures(film, camera), 1) << "a still";
}

TEST(Frame, AFilmThatLoopsDoesSoWithItsExposures) {
  Scene scene = scene_at("tests/presets/tiny_film.json");
  for (Specimen& s : scene.specimens)
    s.motion.growth = {}, s.motion.food.strength = 0, s.motion.wave.speed = 1;
  Camera& camera = scene.setup.camera;
  camera.location = Animated<Vec3>(Vec3(0, 0.6, 2.2));
  camera.shutter = 1, camera.shutter_samples = 2;
  FrameParts parts = prepare_frames(scene);
  auto exposed = [&](int frame, int exposure) {
    std::string text;
    EXPECT_TRUE(write_frame(
        scene, parts, "{{organisms}}", frame, [&](std::string_view some) { text += some; }, exposure));
    return text;
  };
  EXPECT_EQ(exposed(1, 2), exposed(scene.film.frames + 1, 2));
  EXPECT_NE(exposed(1, 2), exposed(2, 2));
}

TEST(Frame, ExposesTheStudioToo) {
  Scene scene = scene_at("tests/presets/tiny_vases.json");
  ASSERT_TRUE(text_of(scene, 1).find("Studio_Room(") != std::string::npos);
  EXPECT_EQ(count(text_of(scene, 1), "Studio_Lamp("), 4u);
  EXPECT_EQ(count(text_of(scene, 1), "rgb <1.28,1.2288,1.152>"), 1u) << "the main light";
  scene.setup.camera.exposure = 2;
  scene.setup.camera.highlights = 1;
  EXPECT_EQ(count(text_of(scene, 1), "rgb <2.56,2.4576,2.304>"), 1u) << "one stop more";
}

TEST(Frame, RefusesAHoleItDoesNotKnow) {
  Scene scene = scene_at("tests/presets/tiny_still.json");
  auto text = frame_text(scene, prepare_frames(scene), "{{frame}} {{fraem}}", 1);
  ASSERT_FALSE(text.ok());
  EXPECT_NE(text.errors()[0].text().find("fraem"), std::string::npos);
}

}  // namespace
}  // namespace frond
