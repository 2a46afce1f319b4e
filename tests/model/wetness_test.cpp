#include "model/wetness.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

TEST(Wetness, DarkensAndMostInTheMiddle) {
  double darkest = 1, darkest_at = 0;
  for (double albedo = 0.05; albedo < 1; albedo += 0.01) {
    double wet = albedo * wet_factor(albedo) + kFilmMirrors;
    EXPECT_LT(wet, albedo) << albedo;
    EXPECT_GT(wet_factor(albedo), wet_factor(albedo - 0.01));
    if (wet / albedo < darkest) darkest = wet / albedo, darkest_at = albedo;
  }
  EXPECT_NEAR(darkest_at, 0.27, 0.06);
  EXPECT_NEAR(darkest, 0.66, 0.03);
  EXPECT_NEAR(wet_factor(1) + kFilmMirrors, 1, 0.001) << "white stays white";
}

TEST(Wetness, SoakedThingsDarkenMoreThanThoseThatWaterStaysOn) {
  for (int i = 0; i < 3; ++i) {
    float soil = wet_colors(row_of(Wetting::soil))[i], leaf = wet_colors(row_of(Wetting::leaf))[i];
    EXPECT_LT(soil, 0.7f);
    EXPECT_GT(leaf, 0.85f);
    EXPECT_EQ(wet_colors(row_of(Wetting::glaze))[i], 1);
  }
}

TEST(Wetness, WaterIsNotWet) {
  EXPECT_FALSE(wetting_of(Matter::water));
  EXPECT_FALSE(wetting_of(Matter::glass));
  EXPECT_EQ(wetting_of(Matter::brick), Wetting::stone);
  EXPECT_EQ(wetting_of(Matter::timber), Wetting::wood);
}

}  // namespace
}  // namespace frond
