#include "settings/sky.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frond {
namespace {

double height(double latitude, double day, double hour) {
  return degrees(std::asin(static_cast<double>(sun_at({hour, day, radians(latitude), 0}).y)));
}

float bright(Vec3 c) { return glm::dot(c, Vec3(0.2126f, 0.7152f, 0.0722f)); }

TEST(SunAt, StandsAsAlmanacsHaveIt) {
  // Declinations of the Astronomical Almanac, at noon of years between leap years.
  const double table[][2] = {{1, -23.0},  {32, -17.2}, {80, -0.1},   {121, 15.0},  {172, 23.44},
                             {213, 18.0}, {266, -0.1}, {305, -14.5}, {355, -23.44}};
  for (auto [day, tilt] : table) EXPECT_NEAR(degrees(declination(day)), tilt, 0.45) << day;
  EXPECT_NEAR(height(50, 172, 13), 63.4, 0.1) << "midsummer's noon";
  EXPECT_NEAR(height(50, 355, 13), 16.6, 0.1) << "midwinter's noon";
  EXPECT_NEAR(height(0, 80, 13), 90, 0.6) << "the equator in spring";
  EXPECT_NEAR(height(-33.9, 355, 13), 79.5, 0.2) << "Sydney in December";
  EXPECT_GT(height(69.6, 172, 1), 0) << "Tromso's midnight sun";
  EXPECT_LT(height(69.6, 355, 13), 0) << "Tromso's polar night";
}

TEST(SunAt, RisesAndSetsWhenAlmanacsHaveIt) {
  // Lengths of days from sunrise to sunset, refracted and of the upper limb: hours.
  const double table[][3] = {{51.5, 172, 16.64}, {51.5, 355, 7.83},  {51.5, 80, 12.15},
                             {0, 172, 12.12},    {40.7, 172, 15.09}, {60.2, 355, 5.82}};
  for (auto [latitude, day, length] : table)
    EXPECT_NEAR(height(latitude, day, 13 + length / 2), -0.833, 0.35) << latitude << ' ' << day;
}

TEST(SunAt, GoesFromLeftToRightBeforeWhoLooksSouth) {
  Moment when;
  when.hour = 8;
  EXPECT_GT(sun_at(when).x, 0.5f) << "east lies toward +x for who has south at +z";
  when.south = kPi / 2;
  when.hour = 13;
  EXPECT_GT(sun_at(when).x, 0.4f);
}

TEST(Preetham, HasThePapersZenith) {
  // By the paper's appendix A.2 for turbidity 3 and a sun 30 and 60 degrees from the zenith, reckoned apart.
  Luminance high = preetham(0, radians(30.0), radians(30.0), 3);
  EXPECT_NEAR(high.Y, 10.41, 0.02);
  Luminance low = preetham(0, radians(60.0), radians(60.0), 3);
  EXPECT_NEAR(low.Y, 5.14, 0.02);
  EXPECT_NEAR(preetham(0, kPi / 2, kPi / 2, 2).Y, 1.99, 0.01);
  for (double sun : {20.0, 45.0, 70.0, 89.0}) {
    Luminance zenith = preetham(0, radians(sun), radians(sun), 2.5);
    EXPECT_TRUE(zenith.x > 0.22 && zenith.x < 0.29 && zenith.y > 0.22 && zenith.y < 0.32) << "blue, " << sun;
  }
}

TEST(Preetham, IsBluerAboveAndBrightestRoundTheSun) {
  for (double sun : {30.0, 60.0, 80.0}) {
    double s = radians(sun), far = radians(85.0);
    EXPECT_LT(preetham(0, s, s, 2.5).x, preetham(far, far + s, s, 2.5).x);
    for (double away : {20.0, 45.0, 90.0})
      EXPECT_GT(preetham(s, 0, s, 2.5).Y, 1.5 * preetham(s, radians(away), s, 2.5).Y) << sun << ' ' << away;
  }
}

TEST(ThroughAir, LeavesWhatIsMeasured) {
  // Direct light of a clear day by the IES: 127.5 klx * exp(-0.21 / sin(height)).
  for (double up : {60.0, 40.0, 25.0, 15.0}) {
    double expected = std::exp(-0.21 / std::sin(radians(up)));
    EXPECT_NEAR(static_cast<double>(bright(through_air(radians(up), 2.5))) / expected, 1, 0.25) << up;
  }
  Vec3 low = through_air(radians(3.0), 2.5), high = through_air(radians(60.0), 2.5);
  EXPECT_GT(low.r / low.b, 4 * high.r / high.b) << "red at the horizon";
  EXPECT_LT(bright(through_air(radians(30.0), 6)), bright(through_air(radians(30.0), 2)));
}

Sky at_height(double up, double exposure = 0) {
  double r = radians(up);
  return Sky({.sun = Vec3(0, std::sin(r), std::cos(r)), .exposure = exposure});
}

TEST(SkyOfTheDay, IsWarmBesideALowSunAndColdAbove) {
  Sky low = at_height(6), noon = at_height(60);
  EXPECT_GT(low.lamplight.r / low.lamplight.b, 2.5f);
  EXPECT_LT(noon.lamplight.r / noon.lamplight.b, 1.5f);
  EXPECT_GT(low.zenith.b / low.zenith.r, 1.5f);
  EXPECT_GT(low.from(glm::normalize(Vec3(0, 0.05f, 1))).r, low.from(glm::normalize(Vec3(0, 0.05f, -1))).r);
  EXPECT_NEAR(bright(noon.lamplight), 3, 0.5f);
}

TEST(SkyOfTheDay, HasNoDaytimeAfterSunset) {
  float last = 10;
  for (double up : {2.0, -2.0, -5.0, -9.0, -14.0}) {
    float zenith = bright(at_height(up).zenith);
    EXPECT_LT(zenith, last) << up;
    last = zenith;
  }
  Sky night = at_height(-20), dusk = at_height(-4);
  EXPECT_LT(bright(night.zenith), 0.02f);
  EXPECT_GT(dusk.zenith.b, 1.5f * dusk.zenith.r) << "the blue hour";
  Vec3 after = dusk.from(glm::normalize(Vec3(0, 0.03f, 1)));
  EXPECT_GT(after.r, 1.3f * after.b) << "the afterglow";
}

TEST(SkyOfTheDay, ShadowsOfANightFallFromTheMoon) {
  SkyShape night{.sun = {0.3f, -0.8f, 0.5f}};
  night.moon = {2, 2, 0};
  EXPECT_NEAR(glm::distance(Sky(night).lamp, glm::normalize(Vec3(1, 1, 0))), 0, 1e-5);
  night.moon = {0, -1, 1};  // below the horizon: just above it
  EXPECT_GT(Sky(night).lamp.y, 0);
  SkyShape day{.sun = {0.3f, 0.8f, 0.5f}};
  day.moon = night.moon;
  EXPECT_NEAR(glm::distance(Sky(day).lamp, Sky(day).sun), 0, 1e-5);
}

TEST(SkyOfTheDay, ChangesWithoutJumps) {
  for (double up = -25; up < 89; up += 0.5) {
    Sky a = at_height(up), b = at_height(up + 0.5);
    for (Vec3 way : {Vec3(0, 1, 0), Vec3(0, 0.1f, 1), Vec3(1, 0.3f, 0), Vec3(0, 0.05f, -1)})
      EXPECT_LT(glm::distance(a.from(glm::normalize(way)), b.from(glm::normalize(way))), 0.11f) << up;
    EXPECT_LT(glm::distance(a.lamplight, b.lamplight), 0.6f) << up;
  }
}

TEST(SkyOfTheDay, IsWhiterWithCloudsAndCoveredByThem) {
  auto with = [](double clouds) { return Sky({.sun = Vec3(0, 1, 1), .clouds = clouds}); };
  Sky clear = with(0), fair = with(0.4), covered = with(1);
  EXPECT_EQ(clear.cloudy_zenith, clear.zenith);
  EXPECT_EQ(clear.cloudy_horizon, clear.horizon);
  auto blue = [](Vec3 light) { return light.b / light.r; };
  EXPECT_LT(blue(fair.cloudy_zenith), blue(clear.zenith));
  EXPECT_LT(blue(covered.cloudy_zenith), 0.7f * blue(clear.zenith));
  EXPECT_GT(bright(fair.cloudy_horizon), bright(clear.horizon)) << "sunlit clouds";
}

TEST(SkyOfTheDay, TakesItsColoursAndExposureFromThePreset) {
  Sky given({.sun = Vec3(0, 1, 1), .zenith = Vec3(0.1f, 0.2f, 0.3f), .horizon = Vec3(0.4f)});
  EXPECT_LT(glm::distance(given.zenith, Vec3(0.1f, 0.2f, 0.3f)), 0.06f);
  EXPECT_LT(glm::distance(given.horizon, Vec3(0.4f)), 0.08f);
  EXPECT_NEAR(bright(at_height(40, 1).lamplight) / bright(at_height(40).lamplight), 2, 0.01);
  EXPECT_GT(bright(at_height(40, 1).zenith), bright(at_height(40).zenith));
}

}  // namespace
}  // namespace frond
