#include "motion/snowfall.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/vec.h"

namespace frond {
namespace {

TEST(Snowfall, FallsAtAboutAMetreASecond) {
  for (double melted : {0.5, 1.0, 2.0}) {
    EXPECT_NEAR(flake_speed(melted), 1, 0.3) << melted;
    EXPECT_NEAR(melted_diameter(flake_diameter(melted)), melted, 1e-9);
  }
  EXPECT_NEAR(flake_diameter(1), 4.1, 0.1);
}

TEST(Snowfall, CarriesAboutTheWaterOfItsRate) {
  for (double rate : {0.3, 1.0, 3.0}) {
    double carried = 0, step = 0.01;  // mm3 on a square metre in a second
    for (double d = step / 2; d < 12; d += step)
      carried += kPi / 6 * d * d * d * flake_speed(d) *
                 (flakes_larger(rate, d - step / 2) - flakes_larger(rate, d + step / 2));
    EXPECT_NEAR(0.0036 * carried / rate, 1, 0.5) << "the two laws were measured in different snow";
  }
}

TEST(Snowfall, HidesWhatIsFar) {
  EXPECT_EQ(snowfall_extinction(0), 0);
  double visible = std::log(50) / snowfall_extinction(1);
  EXPECT_GT(visible, 400);
  EXPECT_LT(visible, 800) << "metres, as in moderate snow";
  EXPECT_GT(snowfall_extinction(3), snowfall_extinction(1));
  EXPECT_EQ(snow_clouds(0), 0);
  EXPECT_EQ(snow_clouds(0.5), 1);
}

}  // namespace
}  // namespace frond
