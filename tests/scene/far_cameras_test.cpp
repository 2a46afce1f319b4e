#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <ctime>

#include "scene/scene.h"
#include "settings/settings.h"

namespace frond {
namespace {

/// A vase in a setting, with rain or snow and far land where these can be.
Preset vase_in(std::string_view setting, bool wet) {
  bool outdoors = setting != "studio" && setting != "underwater";
  std::string air = !outdoors ? ""
                    : wet     ? R"(, "rain": {"rate": 4, "fallen": 20}, "far": {})"
                              : R"(, "snow": {"depth": 0.1})";
  std::string text = fmt::format(
      R"({{"film": {{"frames": 1, "size": [64, 36]}}, "scene": {{"setting": "{}"{}}},
      "organisms": [{{"kind": "vase", "name": "v", "height": 2}}]}})",
      setting, air);
  Result<Preset> preset = read_preset(text, "test.json", {});
  if (!preset) ADD_FAILURE() << preset.errors().front().text();
  return *preset;
}

double seconds_of(const auto& work) {
  std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// Places from 0.1 m to 5 km, near the ground and high above it, with angles from 0.5 to 170 degrees.
TEST(FarCameras, ScenesOfAllSettingsEndInSecondsWhereverTheCameraIs) {
  constexpr int kPlaces = 14;   // far_cameras/all has forty
  constexpr double kMost = 12;  // seconds of all processors, where a usual one takes less than one
  for (const SettingRow& row : settings())
    for (int i = 0; i < kPlaces; ++i) {
      Preset preset = vase_in(row.name, i % 2 == 0);
      double far = 0.1 * std::pow(50'000, i / (kPlaces - 1.0)), turn = 2.4 * i;
      Camera& camera = preset.setup.camera;
      double high = i % 3 == 0 ? 0.7 * far : 1 + 0.02 * far;
      camera.location = Animated<Vec3>(Vec3(far * std::cos(turn), high, far * std::sin(turn)));
      camera.look_at = Animated<Vec3>(Vec3(0, 0.5, 0));
      camera.angle = Animated<double>(0.5 * std::pow(340, (7 * i % kPlaces) / (kPlaces - 1.0)));
      std::size_t triangles = 0;
      double seconds = seconds_of([&] {
        Result<Scene> scene = build_scene(preset);
        ASSERT_TRUE(scene) << scene.errors().front().text();
        triangles = scene->ground->floor().triangle.size();
      });
      EXPECT_LT(seconds, kMost) << row.name << " from " << far << " m";
      EXPECT_LT(triangles, 1'000'000u) << row.name << " from " << far << " m";
    }
}

TEST(FarCameras, AreRefusedWithAReasonBeyondAKilometre) {
  for (const SettingRow& row : settings()) {
    Result<Preset> preset = read_preset(
        fmt::format(
            R"({{"film": {{"frames": 1}}, "scene": {{"setting": "{}", "camera": {{"location": [0, 2, 5000]}}}}, "organisms": []}})",
            row.name),
        "far.json", {});
    ASSERT_FALSE(preset) << row.name;
    EXPECT_NE(preset.errors().front().text().find("/scene/camera/location"), std::string::npos);
    EXPECT_NE(preset.errors().front().text().find("1000"), std::string::npos);
  }
}

/// The place from which the middle of a garden was as slow as all its triangles together.
TEST(FarCameras, AGardenFromFourHundredMetresTakesHardlyLongerThanFromTwenty) {
  auto seconds = [](float far) {
    Preset preset = vase_in("garden", true);
    preset.setup.camera.location = Animated<Vec3>(Vec3(0, 5, far));
    return seconds_of([&] { EXPECT_TRUE(build_scene(preset)); });
  };
  EXPECT_LT(seconds(400), 4 * seconds(20) + 2);
}

TEST(FarCameras, NobodyWaitsForASceneThatIsGivenUpWhileItsPuddlesFill) {
  Preset preset = vase_in("meadow", true);
  std::atomic<bool> surrounds = false;
  std::atomic<int> asked = 0;
  ProgressSink watch{[&](std::string_view phase, std::size_t) { surrounds = phase == "surround"; }, [] {},
                     [&] { return surrounds && ++asked > 3; }};
  Result<Scene> scene = build_scene(preset, watch);
  ASSERT_FALSE(scene) << "it was built to its end";
  EXPECT_EQ(scene.errors().front().what, "given up");
}

}  // namespace
}  // namespace frond
