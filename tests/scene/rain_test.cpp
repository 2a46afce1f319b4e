#include "scene/rain.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "motion/rain.h"
#include "settings/meadow.h"
#include "settings/settings.h"

namespace frond {
namespace {

Scene rainy_scene(const std::string& rain, const std::string& setting = "garden") {
  std::string text =
      R"({"film": {"frames": 24, "size": [160, 90]}, "scene": {"setting": ")" + setting +
      R"(", "camera": {"location": [0, 1.6, 6], "look_at": [0, 0.4, 0]}, "meadow": {"blade": 0},
      "floor": {"relief": 0.3}, "garden": {"pond": {"center": [3, 0], "size": [1, 1]}})" +
      rain + R"(}, "organisms": [{"kind": "vase", "name": "vase", "place": {"at": [[0, 0]]}}]})";
  Result<Preset> preset = read_preset(text, "test.json", {});
  if (!preset) ADD_FAILURE() << preset.errors().front().text();
  return *build_scene(*preset);
}

const Specimen* water_of(const Scene& scene) {
  auto at = std::ranges::find(scene.specimens, "puddles", &Specimen::name);
  return at == scene.specimens.end() ? nullptr : &*at;
}

TEST(SceneRain, FillsHollowsOutsideOfThePond) {
  EXPECT_FALSE(water_of(rainy_scene("")));
  EXPECT_FALSE(water_of(rainy_scene(R"(, "rain": {"fallen": 0})")));
  EXPECT_FALSE(water_of(rainy_scene(R"(, "rain": {})", "underwater")));
  Scene scene = rainy_scene(R"(, "rain": {"fallen": 8})");
  const Specimen* water = water_of(scene);
  ASSERT_TRUE(water);
  EXPECT_EQ(water->find_fault(), "");
  EXPECT_TRUE(
      std::ranges::all_of(scene.specimens, [](const Specimen& s) { return s.wet || s.name == "puddles"; }));
  for (const Vec3& p : water->model.solids.shapes[0].surface.position) {
    EXPECT_GT(glm::distance(Vec2(p.x, p.z), Vec2(3, 0)), 0.7f);
    EXPECT_LT(p.y, scene.ground->height({p.x, p.z}) + 0.15f);
  }
}

TEST(SceneRain, PuddlesGrowAndDryUp) {
  Scene scene = rainy_scene(R"(, "rain": {"fallen": [[0, 0], [0.5, 8], [1, 1]]})");
  const Specimen* water = water_of(scene);
  ASSERT_TRUE(water && water->life.develop);
  auto faces = [&](double time) {
    Model now = *water->life.develop(time);
    return now.solids.shapes.empty() ? 0 : now.solids.shapes[0].surface.triangle.size();
  };
  EXPECT_EQ(faces(0), 0u);
  EXPECT_GT(faces(0.5), faces(0.25));
  EXPECT_GT(faces(0.5), faces(1));
}

TEST(SceneRain, FallsFromADimGreySky) {
  for (std::string_view name : {"meadow", "garden", "forest"}) {
    SceneSetup setup;
    setup.setting = row_of(name);
    Daylight dry = drawn_daylight(setup_at(setup, 0));
    setup.rain = Rain{.rate = Animated<double>({{0, 0.0}, {1, 20.0}})};
    EXPECT_EQ(drawn_daylight(setup_at(setup, 0)).sunlight, dry.sunlight) << "before it begins";
    Daylight wet = drawn_daylight(setup_at(setup, 1));
    EXPECT_LT(wet.sunlight.g, 0.1f * dry.sunlight.g);
    EXPECT_LT(wet.above.b / wet.above.r, 1.2f) << "grey";
    EXPECT_GT(wet.above.g, 0.3f) << "but bright";
    EXPECT_LT(wet.fade, dry.fade) << "of the air";
    EXPECT_NEAR(1 / wet.fade - 1 / dry.fade, rain_extinction(20), 1e-9);
    EXPECT_LT(wet.thrown_back.g, dry.thrown_back.g);
    EXPECT_TRUE(sun_moves(setup));
  }
  SceneSetup sea;
  sea.rain = Rain{};
  EXPECT_FALSE(is_rainy(sea)) << "under water";
}

}  // namespace
}  // namespace frond
