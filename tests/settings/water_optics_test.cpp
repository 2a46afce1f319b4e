#include "settings/water_optics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace frond {
namespace {

TEST(WaterOptics, TypesAreInTheOrderInWhichOneSeesLess) {
  float last = 0;
  for (const auto& row : kWaterTypes) {
    WaterOptics optics = water_optics(row.value, 0);
    EXPECT_GT(optics.direct.g, last) << row.name;
    last = optics.direct.g;
  }
}

// One sees black things as far as four times the inverse of the attenuation (Duntley 1963).
TEST(WaterOptics, OneSeesAsFarAsEachTypeSays) {
  for (const auto& row : kWaterTypes) {
    std::size_t said = row.doc.find("about ");
    double metres = std::stod(std::string(row.doc.substr(said + 6)));
    EXPECT_NEAR(4 / water_optics(row.value, 0).direct.g / metres, 1, 0.1) << row.name;
  }
}

// Jerlov (1976), as Austin and Petzold (1984) have it: of type I a metre takes 1.8 % of light of 450 to 475
// nm, of IB 3.5 %, and of red of 625 nm more than a quarter.
TEST(WaterOptics, DaylightIsLeftAsItWasMeasured) {
  EXPECT_NEAR(water_optics(WaterType::I, 10).passed.b, std::exp(-10 * 0.0184), 0.06);
  EXPECT_NEAR(water_optics(WaterType::IB, 10).passed.b, std::exp(-10 * 0.036), 0.06);
  EXPECT_LT(water_optics(WaterType::IB, 10).passed.r, std::exp(-10 * 0.25));
}

// Akkaynak and Treibitz (2018): things fade by another coefficient than the veil grows by.
TEST(WaterOptics, ThingsFadeFasterThanTheVeilCloses) {
  for (const auto& row : kWaterTypes)
    for (double depth : {0.0, 5.0, 20.0}) {
      WaterOptics optics = water_optics(row.value, depth);
      for (int c = 0; c < 3; ++c) {
        EXPECT_GE(optics.direct[c], optics.backscatter[c] * 0.9999f) << row.name << ' ' << depth;
        EXPECT_GT(optics.backscatter[c], 0) << row.name << ' ' << depth;
      }
    }
  WaterOptics reef = water_optics(WaterType::IB, 0);
  EXPECT_GT(reef.direct.r, 1.08f * reef.backscatter.r);
}

TEST(WaterOptics, DeeperDownTheRedThatIsLeftGoesFarther) {
  for (const auto& row : kWaterTypes)
    EXPECT_LT(water_optics(row.value, 15).direct.r, 0.99f * water_optics(row.value, 0).direct.r) << row.name;
}

TEST(WaterOptics, OceansAreBlueAndCoastsGreen) {
  for (const auto& row : kWaterTypes) {
    WaterOptics optics = water_optics(row.value, 8);
    bool ocean = row.value <= WaterType::II;
    EXPECT_GT(ocean ? optics.veil.b : optics.veil.g, ocean ? optics.veil.g : optics.veil.b) << row.name;
    EXPECT_GT(optics.veil.g, 2 * optics.veil.r) << row.name;
  }
}

}  // namespace
}  // namespace frond
