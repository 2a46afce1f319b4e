#include "settings/settings.h"

#include <gtest/gtest.h>

#include <set>

#include "settings/forest.h"
#include "settings/garden.h"

namespace frond {
namespace {

SceneSetup setup_of(std::string_view setting, double exposure = 0) {
  SceneSetup setup;
  setup.setting = row_of(setting);
  setup.camera.exposure = exposure;
  return setup;
}

TEST(Settings, HaveNamesOfTheirOwnByWhichTheyAreFound) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < settings().size(); ++i) {
    EXPECT_TRUE(names.insert(settings()[i].name).second);
    EXPECT_EQ(row_of(settings()[i].name), i);
  }
  EXPECT_EQ(row_of("nowhere"), settings().size());
}

TEST(Daylight, OfEachSettingIsLightThatCanBe) {
  for (const SettingRow& row : settings()) {
    SCOPED_TRACE(row.name);
    Daylight light = daylight_of(setup_of(row.name));
    EXPECT_NEAR(glm::length(light.sun), 1, 1e-4);
    for (int c = 0; c < 3; ++c) {
      EXPECT_GT(light.sunlight[c], 0);
      EXPECT_GE(light.fog[c], 0);
      EXPECT_GE(light.above[c], 0);
      EXPECT_GE(light.thrown_back[c], 0);
      EXPECT_LE(light.thrown_back[c], 1) << "land throws back no more than it gets";
    }
    EXPECT_GE(light.fade, 0);
    ASSERT_FALSE(light.backdrop.empty());
    EXPECT_LE(light.backdrop.size(), kBackdropStops);
    for (std::size_t i = 1; i < light.backdrop.size(); ++i)
      EXPECT_GT(light.backdrop[i].height, light.backdrop[i - 1].height);
  }
}

TEST(Hour, HasKeyframesByWhichTheSunMoves) {
  for (const char* name : {"meadow", "garden", "forest"}) {
    SCOPED_TRACE(name);
    SceneSetup setup = setup_of(name), noon = setup;
    EXPECT_FALSE(sun_moves(setup));
    Animated<double> day(std::vector<Animated<double>::Key>{{0, 6}, {10, 20}}), at_noon(13.0);
    setup.block<Meadow>().hour = setup.block<Garden>().hour = setup.block<Forest>().hour = day;
    noon.block<Meadow>().hour = noon.block<Garden>().hour = noon.block<Forest>().hour = at_noon;
    EXPECT_TRUE(sun_moves(setup));
    auto height = [&](double time) { return drawn_daylight(setup_at(setup, time)).sun.y; };
    EXPECT_LT(height(0), 0.3f);
    EXPECT_LT(height(10), 0.3f);
    EXPECT_NEAR(height(5), drawn_daylight(noon).sun.y, 1e-5);
    EXPECT_GT(height(5), 0.8f);
    EXPECT_FALSE(sun_moves(setup_at(setup, 5)));
    EXPECT_EQ(drawn_daylight(setup).sun, drawn_daylight(setup_at(setup, 0)).sun);
  }
  EXPECT_FALSE(sun_moves(setup_of("underwater")));
}

TEST(Backdrop, GoesFromStopToStopWithoutJumps) {
  Daylight light;
  light.backdrop = {{0.1, Vec3(1)}, {0.5, Vec3(0)}};
  EXPECT_EQ(backdrop_at(light, -1), Vec3(1));
  EXPECT_EQ(backdrop_at(light, 0.1f), Vec3(1));
  EXPECT_NEAR(backdrop_at(light, 0.3f).x, 0.5, 1e-5);
  EXPECT_EQ(backdrop_at(light, 1), Vec3(0));
}

TEST(Daylight, OfTheStudioFollowsTheExposure) {
  Daylight plain = daylight_of(setup_of("studio")), bright = daylight_of(setup_of("studio", 1));
  EXPECT_GT(bright.sunlight.x, 1.5f * plain.sunlight.x);
}

}  // namespace
}  // namespace frond
