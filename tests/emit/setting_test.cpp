#include "emit/setting.h"

#include <gtest/gtest.h>

#include "draw/ambience.h"
#include "emit/setting_parts.h"
#include "emit/texts.h"
#include "settings/settings.h"
#include "settings/underwater.h"

namespace frond {
namespace {

TEST(Setting, FramesAndSoftLightHaveTheSunOfItsTable) {
  Scene scene = scene_at("tests/presets/tiny_film.json");
  for (std::string_view name : {"underwater", "studio", "meadow", "garden", "forest"}) {
    scene.setup.setting = row_of(name);
    Daylight light = drawn_daylight(scene.setup);
    if (name == "underwater" || name == "studio") {
      EXPECT_NE(setting_text(scene, 0).find(light_text(light.sunlight)), std::string::npos) << name;
    }
    std::optional<Ambience> ambience = ambience_of(scene, 0);
    EXPECT_EQ(ambience.has_value(), name != "studio") << name;
    if (!ambience) continue;
    EXPECT_EQ(ambience->sun, light.sun) << name;
    EXPECT_EQ(ambience->sunlight, light.sunlight) << name;
  }
}

TEST(Setting, DeepWaterTakesRedFromTheSunOfAllPictures) {
  Scene scene = scene_at("tests/presets/tiny_film.json");
  scene.setup.setting = row_of("underwater");
  Vec3 shallow = daylight_of(scene.setup).sunlight;
  for (std::any& block : scene.setup.blocks)
    if (auto* water = std::any_cast<Water>(&block)) water->depth = 8;
  Vec3 left = daylight_of(scene.setup).sunlight / shallow;
  EXPECT_LT(left.r, 0.1f);
  EXPECT_GT(left.b, 0.7f);
  EXPECT_NE(setting_text(scene, 0).find(light_text(left * shallow)), std::string::npos);
}

}  // namespace
}  // namespace frond
