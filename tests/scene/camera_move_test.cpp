#include "scene/camera_move.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "scene/preset.h"

namespace frond {
namespace {

constexpr int kFrames = 48;

/// The camera of a film of two seconds with that move.
Camera filmed(const std::string& move) {
  Result<Preset> preset =
      read_preset(fmt::format(
                      R"({{"film": {{"frames": {}, "fps": 24}}, "scene": {{"setting": "studio", "camera": {{
                "location": [0, 1, 4], "look_at": [1, 0.5, 0], "move": {}}}}}, "organisms": []}})",
                      kFrames, move),
                  "test.json", {});
  EXPECT_TRUE(preset) << preset.errors().front().text();
  EXPECT_FALSE(preset->setup.camera.move);
  return preset->setup.camera;
}

/// The longest way and the largest change of it from frame to frame, the first again behind the last.
std::pair<float, float> steps_of(const Animated<Vec3>& path) {
  float longest = 0, change = 0;
  Vec3 before(0);
  for (int frame = -1; frame <= kFrames; ++frame) {
    auto at = [&](int f) { return path.at(((f + kFrames) % kFrames) / 24.0); };
    Vec3 step = at(frame + 1) - at(frame);
    if (frame >= 0) change = std::max(change, glm::length(step - before));
    longest = std::max(longest, glm::length(step));
    before = step;
  }
  return {longest, change};
}

TEST(CameraMove, AnOrbitKeepsItsDistanceAndRepeats) {
  Camera camera = filmed(R"({"orbit": {"turn": 360}})");
  for (int i = 0; i <= 2 * kFrames; ++i) {
    Vec3 at = camera.location.at(i / 48.0);
    EXPECT_NEAR(std::hypot(at.x - 1, at.z), std::hypot(1, 4), 2e-3) << i;
    EXPECT_FLOAT_EQ(at.y, 1);
  }
  EXPECT_GT(camera.location.at(0.5).x, 3) << "a quarter to the right";
  auto [longest, change] = steps_of(camera.location);
  EXPECT_NEAR(longest, 2 * kPi * std::hypot(1, 4) / kFrames, 0.01);
  EXPECT_LT(change, 0.15 * longest) << "at an even pace, over the end as well";
}

TEST(CameraMove, ARailIsStraightAndEasedAtItsEnds) {
  Camera even = filmed(R"({"rail": {"to": [2, 1, 4]}})");
  Camera both = filmed(R"({"rail": {"to": [2, 1, 4]}, "ease": "both"})");
  for (double t = 0; t < 2; t += 0.1) {
    EXPECT_NEAR(even.location.at(t).x, t, 1e-4);
    EXPECT_FLOAT_EQ(both.location.at(t).z, 4);
  }
  EXPECT_LT(both.location.at(0.1).x, 0.02);
  EXPECT_NEAR(both.location.at(1).x, 1, 1e-3);
  EXPECT_NEAR(both.location.at(2).x, 2, 1e-4);
  EXPECT_EQ(even.look_at.at(1), Vec3(1, 0.5f, 0));
}

TEST(CameraMove, RailAndOrbitAddUp) {
  Camera camera =
      filmed(R"({"rail": {"to": [0, 1, 8]}, "orbit": {"turn": 90, "rise": 2, "center": [0, 0, 0]}})");
  Vec3 end = camera.location.at(2);
  EXPECT_NEAR(end.x, 8, 1e-2);
  EXPECT_NEAR(end.y, 3, 1e-3);
  EXPECT_NEAR(end.z, 0, 1e-2);
}

TEST(CameraMove, AHandShakesWithinItsAmplitudeAndRepeats) {
  Camera camera = filmed(R"({"shake": {"amplitude": 2, "frequency": 0.8}})");
  EXPECT_TRUE(camera.location.constant());
  Vec3 ahead = glm::normalize(Vec3(1, -0.5f, -4));
  float most = 0;
  for (int i = 0; i <= 200; ++i) {
    Vec3 to = glm::normalize(camera.look_at.at(i / 100.0) - Vec3(0, 1, 4));
    most = std::max(most, std::acos(std::min(1.0f, glm::dot(to, ahead))));
  }
  EXPECT_LT(most, std::sqrt(2) * radians(2.0));
  EXPECT_GT(most, radians(0.7));
  auto [longest, change] = steps_of(camera.look_at);
  EXPECT_LT(change, 0.5 * longest) << "no jump, at the end neither";
}

TEST(CameraMove, SwingsDoNotRepeatWhereTheyNeedNot) {
  Shake shake{.amplitude = 1, .frequency = 0.8, .loop = false};
  EXPECT_GT(glm::distance(shaken(shake, 0, 2), shaken(shake, 2, 2)), 0.1f);
  shake.loop = true;
  EXPECT_LT(glm::distance(shaken(shake, 0, 2), shaken(shake, 2, 2)), 1e-5f);
  for (double t = 0; t < 50; t += 0.37) EXPECT_LE(std::abs(shaken(shake, t, 2).x), 1.0f) << t;
}

TEST(CameraMove, AStillStandsStill) {
  Camera camera;
  camera.move = CameraMove{.orbit = Orbit{}, .rail = {}, .shake = Shake{}};
  Film still;
  still.frames = 1;
  EXPECT_TRUE(keyed_move(camera, still).location.constant());
  EXPECT_TRUE(keyed_move(camera, still).look_at.constant());
}

TEST(GrowthToTheEnd, LastsUntilTheLastFrame) {
  auto duration = [](const std::string& growth, const std::string& defaults = "{}", int frames = 49) {
    Result<Preset> preset = read_preset(fmt::format(R"({{"film": {{"frames": {}, "fps": 24}}, "defaults": {},
                        "organisms": [{{"kind": "coral"{}}}, {{"kind": "rock"}}]}})",
                                                    frames, defaults, growth),
                                        "test.json", {});
    EXPECT_TRUE(preset) << preset.errors().front().text();
    return preset->organisms[0].grower->appearance().motion.growth.duration;
  };
  EXPECT_DOUBLE_EQ(duration(R"(, "growth": {"to_end": true})"), 2);
  EXPECT_DOUBLE_EQ(duration(R"(, "growth": {"to_end": true, "start": 0.5, "stagger": 0.25, "duration": 9})"),
                   1.25);
  EXPECT_DOUBLE_EQ(duration(R"(, "growth": {"start": 0.5})", R"({"growth": {"to_end": true}})"), 1.5);
  EXPECT_DOUBLE_EQ(duration("", R"({"growth": {"to_end": true, "start": 1}})"), 1);
  EXPECT_DOUBLE_EQ(duration(R"(, "growth": {"to_end": true})", "{}", 1), 0) << "a still shows what has grown";
  EXPECT_DOUBLE_EQ(duration(R"(, "growth": {"duration": 3})"), 3);
}

}  // namespace
}  // namespace frond
