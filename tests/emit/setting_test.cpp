#include "emit/setting.h"

#include <gtest/gtest.h>

#include <cstdio>

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

/// A scene in water, which a function may change.
template <class Change>
Scene in_water(const Change& change) {
  Scene scene = scene_at("tests/presets/tiny_film.json");
  scene.setup.setting = row_of("underwater");
  change(scene.setup.block<Water>());
  return scene;
}

/// The three numbers that a text of a setting declares under a name.
Vec3 declared(const std::string& text, const std::string& name) {
  Vec3 value(-1);
  std::size_t at = text.find("#declare " + name + " = <");
  if (at == std::string::npos) return value;
  std::sscanf(text.c_str() + text.find('<', at), "<%f,%f,%f>", &value.x, &value.y, &value.z);
  return value;
}

TEST(Water, OfATypeFadesEachColorByItself) {
  Scene plain = in_water([](Water&) {}),
        typed = in_water([](Water&w) { w.type = WaterType::II, w.depth = 7; });
  EXPECT_EQ(setting_text(plain, 0).find("Water_Direct"), std::string::npos);
  std::string text = setting_text(typed, 0);
  WaterOptics optics = water_optics(WaterType::II, 7);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(declared(text, "Water_Direct")[c], optics.direct[c], 1e-4);
    EXPECT_NEAR(declared(text, "Water_Backscatter")[c], optics.backscatter[c], 1e-4);
  }
  EXPECT_NE(text.find("#declare Water_Depth = 7;"), std::string::npos) << "where the surface is";
}

TEST(Water, OfATypeIsOfOneColorForHazeBackdropAndShadows) {
  for (const auto& row : kWaterTypes) {
    Daylight light = daylight_of(in_water([&](Water& w) { w.type = row.value, w.depth = 6; }).setup);
    EXPECT_EQ(light.backdrop[0].light, light.fog) << row.name;
    EXPECT_EQ(light.aside, light.fog) << row.name << ": what faces aside is lit by the water there";
    EXPECT_LE(light.backdrop.size(), kBackdropStops);
    for (std::size_t i = 1; i < light.backdrop.size(); ++i)
      for (int c = 0; c < 3; ++c)  // darker than the haze it cannot be shown
        EXPECT_GE(light.backdrop[i].light[c], light.backdrop[i - 1].light[c]) << row.name;
  }
}

TEST(Water, CausticsLoseContrastWithDepth) {
  Water water{.type = WaterType::IB};
  EXPECT_EQ(caustic_contrast(water), 1);
  for (double last = 1; water.depth < 40;) {
    water.depth += 4;
    EXPECT_LT(caustic_contrast(water), last);
    last = caustic_contrast(water);
    EXPECT_EQ(caustic_contrast(Water{.depth = water.depth}), 1) << "without a type";
  }
  EXPECT_LT(caustic_contrast(water), 0.05);
}

TEST(Water, ShadedSidesAreFilled) {
  Daylight once = daylight_of(in_water([](Water&w) { w.type = WaterType::IB; }).setup),
           twice = daylight_of(in_water([](Water&w) { w.type = WaterType::IB, w.fill = 2; }).setup);
  EXPECT_EQ(twice.aside, 2.0f * once.aside);
  EXPECT_EQ(twice.below, 2.0f * once.below);
  EXPECT_EQ(twice.sunlight, once.sunlight);
}

TEST(Water, WhiteBalanceMakesADeepWhiteCardWhite) {
  Daylight light =
      daylight_of(in_water([](Water& w) { w.type = WaterType::IB, w.depth = 8, w.balance = 1; }).setup);
  Vec3 card = light.sunlight / kSunAtSurface;
  EXPECT_NEAR(card.r / card.g, 1, 1e-3);
  EXPECT_NEAR(card.b / card.g, 1, 1e-3);
  Vec3 lamps = white_balance({.type = WaterType::IB, .depth = 8, .balance = 1}).lamps;
  EXPECT_GT(lamps.r, 1.5f * lamps.g) << "what a lamp shows is too red";
  EXPECT_NEAR(lamps.b, lamps.g, 0.3f);
}

TEST(Water, AtNightThereIsNoLightButThatOfTheTorch) {
  Scene scene = in_water([](Water& w) {
    w.type = WaterType::IB, w.daylight = 0;
    w.strobe = Strobe{.count = 1, .angle = 15};
  });
  Daylight light = daylight_of(scene.setup);
  for (Vec3 none :
       {light.sunlight, light.above, light.aside, light.below, light.fog, light.backdrop[5].light})
    EXPECT_EQ(none, Vec3(0));
  std::string text = setting_text(scene, 0);
  EXPECT_NE(text.find("Water_Strobe("), std::string::npos);
  EXPECT_EQ(text.find("Water_Shafts("), std::string::npos);
}

TEST(Water, StrobesGoWithTheCamera) {
  Scene scene = in_water([](Water& w) { w.strobe = Strobe{.apart = 1}; });
  Camera& camera = scene.setup.camera;
  camera.look_at = Vec3(0, 1, 0);
  for (Vec3 eye : {Vec3(0, 1, 3), Vec3(4, 1, 0)}) {
    camera.location = eye;
    std::string text = setting_text(scene, 0);
    std::size_t at = text.find("#declare Water_Strobes = array[2]{");
    ASSERT_NE(at, std::string::npos);
    Vec3 a, b;
    std::sscanf(text.c_str() + text.find("{<", at), "{<%f,%f,%f>,<%f,%f,%f>}", &a.x, &a.y, &a.z, &b.x, &b.y,
                &b.z);
    Vec3 middle = (a + b) / 2.0f * Vec3(1, 1, -1);  // POV-Ray's z is mirrored
    EXPECT_NEAR(glm::distance(a, b), 1, 1e-3);
    EXPECT_NEAR(glm::dot(a - b, eye * Vec3(1, 1, -1)), 0, 1e-3) << "on both sides";
    EXPECT_NEAR(glm::distance(middle, eye + Vec3(0, 0.2f, 0)), 0, 1e-3);
    EXPECT_EQ(text.find("Water_Ceiling"), std::string::npos);
  }
  camera.location = Vec3(0, 4, 3);
  EXPECT_NE(setting_text(scene, 0).find("#declare Water_Ceiling = 4.3;"), std::string::npos)
      << "caustics stay above the lamps";
}

}  // namespace
}  // namespace frond
