#include "scene/snow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "settings/settings.h"

namespace frond {
namespace {

Scene scene_with(const std::string& snow, const std::string& setting = "garden") {
  std::string text =
      R"({"film": {"frames": 24, "size": [160, 90]}, "scene": {"setting": ")" + setting +
      R"(", "camera": {"location": [0, 1.6, 6], "look_at": [0, 0.4, 0]}, "meadow": {"blade": 0},
      "garden": {"pond": {"center": [3, 0], "size": [1, 1]}})" +
      snow + R"(}, "organisms": [
      {"kind": "vase", "name": "vase", "soil": 0.9, "height": 0.6, "place": {"at": [[0, 0]]}}]})";
  Result<Preset> preset = read_preset(text, "test.json", {});
  if (!preset) ADD_FAILURE() << preset.errors().front().text();
  return *build_scene(*preset);
}

const Specimen* snow_of(const Scene& scene) {
  auto at = std::ranges::find(scene.specimens, "snow", &Specimen::name);
  return at == scene.specimens.end() ? nullptr : &*at;
}

TEST(SceneSnow, IsThereOnlyWhereItIsAskedForUnderTheOpenSky) {
  EXPECT_FALSE(snow_of(scene_with("")));
  EXPECT_FALSE(snow_of(scene_with(R"(, "snow": {"depth": 0, "wind": 90})")));
  EXPECT_FALSE(snow_of(scene_with(R"(, "snow": {"frost": 1})"))) << "frost has no thickness";
  EXPECT_FALSE(snow_of(scene_with(R"(, "snow": {"depth": 0.1})", "underwater")));
  for (std::string setting : {"garden", "meadow", "forest"}) {
    Scene scene = scene_with(R"(, "snow": {"depth": 0.1})", setting);
    const Specimen* snow = snow_of(scene);
    ASSERT_TRUE(snow) << setting;
    EXPECT_EQ(snow->find_fault(), "");
    EXPECT_TRUE(
        std::ranges::all_of(scene.specimens, [](const Specimen& s) { return s.snowy || s.name == "snow"; }));
  }
}

TEST(SceneSnow, LiesOnGroundPondAndVase) {
  Scene scene = scene_with(R"(, "snow": {"depth": 0.1})");
  const Solids& solids = snow_of(scene)->model.solids;
  ASSERT_EQ(solids.shapes.size(), 2u);
  double over_pond = 0;
  for (const Vec3& p : solids.shapes[0].surface.position) {
    EXPECT_GT(static_cast<double>(p.y), scene.ground->heights()(p.x, p.z) - 0.005);
    if (glm::distance(Vec2(p.x, p.z), Vec2(3, 0)) < 0.3) over_pond = p.y - scene.ground->heights()(p.x, p.z);
  }
  EXPECT_GT(over_pond, 0.15) << "on the ice";
  Bounds cap = bounds_of(solids.shapes[1].surface.position);
  EXPECT_GT(cap.low.y, 0.1);
  EXPECT_LT(cap.high.y, 0.6 + 0.15);
}

TEST(SceneSnow, FallsAndMeltsWithoutAJump) {
  Scene scene = scene_with(R"(, "snow": {"depth": [[0, 0], [0.5, 0.12], [1, 0]]})");
  const Specimen* snow = snow_of(scene);
  std::vector<Vec3> last;
  for (double time = 0; time <= 1; time += 0.04) {
    Model now = *snow->life.develop(time);
    if (now.solids.shapes.empty()) continue;  // none lies
    const std::vector<Vec3>& at = now.solids.shapes[0].surface.position;
    for (std::size_t i = 0; i < last.size(); ++i) {
      EXPECT_LT(std::abs(at[i].y - last[i].y), 0.06);
      EXPECT_EQ(at[i].x, last[i].x);
    }
    last = at;
  }
}

TEST(SceneSnow, FallsFromAnOvercastSkyThatHidesWhatIsFar) {
  SceneSetup setup;
  setup.setting = row_of("meadow");
  setup.snow.depth = 0.1;
  Daylight clear = drawn_daylight(setup_at(setup, 0));
  setup.snow.falling = 1;
  EXPECT_EQ(overcast(setup), 1);
  EXPECT_FALSE(sun_moves(setup));
  Daylight dull = drawn_daylight(setup_at(setup, 0));
  EXPECT_LT(dull.sunlight.g, 0.3f * clear.sunlight.g);
  EXPECT_LT(dull.fade, 400);
  setup.snow.falling = Animated<double>({{0, 0}, {1, 2}});
  EXPECT_TRUE(sun_moves(setup));
  EXPECT_EQ(drawn_daylight(setup_at(setup, 0)).sunlight, clear.sunlight) << "it has not begun";
}

TEST(SceneSnow, ThrowsBackTheLightOfTheSky) {
  SceneSetup setup;
  setup.setting = row_of("meadow");
  Daylight summer = drawn_daylight(setup);
  setup.snow.depth = 0.1;
  Daylight winter = drawn_daylight(setup);
  EXPECT_GT(winter.thrown_back.g, 3 * summer.thrown_back.g);
  EXPECT_GT(winter.below.b, 2 * summer.below.b);
  EXPECT_EQ(winter.sunlight, summer.sunlight);
  setup.setting = row_of("underwater");
  EXPECT_FALSE(is_snowy(setup));
}

}  // namespace
}  // namespace frond
