#include "motion/rain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/vec.h"

namespace frond {
namespace {

constexpr double kRates[] = {0.2, 1, 5, 20, 60, 100};
constexpr double kBin = 0.002;  // mm

TEST(Rain, DropsCarryTheRateThatItHas) {
  for (double rate : kRates) {
    // The two laws were measured in different rains: together they carry up to 18 % more.
    double volume = 0;  // mm3 on a square metre in a second
    for (double d = kBin / 2; d < 12; d += kBin)
      volume += drop_density(rate, d) * kBin * kPi / 6 * d * d * d * terminal_speed(d);
    EXPECT_NEAR(volume * 0.0036 / rate, 1, 0.2) << rate;
  }
}

TEST(Rain, CountsAreTheSumsOfTheDensity) {
  for (double rate : kRates)
    for (double least : {0.5, 1.5, 3.0}) {
      double there = 0, land = 0;
      for (double d = least + kBin / 2; d < 20; d += kBin) {
        there += drop_density(rate, d) * kBin;
        land += drop_density(rate, d) * terminal_speed(d) * kBin;
      }
      EXPECT_NEAR(there / drops_thicker(rate, least), 1, 0.01);
      EXPECT_NEAR(land / drops_landing(rate, least), 1, 0.01);
      EXPECT_NEAR(drops_thicker(rate, drop_diameter(rate, least, 0.25)) / drops_thicker(rate, least), 0.25,
                  1e-9);
    }
}

TEST(Rain, TakesLightByTheDropsCrossSections) {
  double last = 0;
  for (double rate : kRates) {
    double area = 0;  // mm2 in a cubic metre
    for (double d = kBin / 2; d < 12; d += kBin) area += drop_density(rate, d) * kBin * kPi / 4 * d * d;
    EXPECT_NEAR(2e-6 * area / rain_extinction(rate), 1, 0.01);
    EXPECT_GT(rain_extinction(rate), last);
    last = rain_extinction(rate);
  }
}

TEST(Rain, IsNothingWhereItDoesNotRain) {
  for (double nothing : {drop_density(0, 1), drops_thicker(0, 1), drops_landing(0, 1), rain_extinction(0),
                         rain_clouds(0), wetness(0)})
    EXPECT_EQ(nothing, 0);
}

TEST(Rain, LargerDropsFallFaster) {
  double last = 0;
  for (double d = 0.1; d < 6; d += 0.1) {
    EXPECT_GE(terminal_speed(d), last);
    last = terminal_speed(d);
  }
  EXPECT_NEAR(terminal_speed(2), 6.5, 0.2) << "Gunn and Kinzer (1949) measured 6.49 m/s";
}

}  // namespace
}  // namespace frond
