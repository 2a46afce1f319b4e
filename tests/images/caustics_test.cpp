#include "images/caustics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace frond {
namespace {

TEST(Caustics, FitOnThemselves) {
  Raster picture = caustics_picture({.pixels = 128});
  double edge = 0, inside = 0;
  for (int i = 0; i < 128; ++i) {
    edge += std::abs(picture.at(127, i) - picture.at(0, i)) + std::abs(picture.at(i, 127) - picture.at(i, 0));
    inside +=
        std::abs(picture.at(63, i) - picture.at(64, i)) + std::abs(picture.at(i, 63) - picture.at(i, 64));
  }
  EXPECT_LT(edge, 2 * inside);
}

TEST(Caustics, ComeBackAfterALoopAndMoveBefore) {
  Caustics caustics{.pixels = 64, .loop = 4};
  Raster first = caustics_picture(caustics);
  caustics.time = 4;
  EXPECT_EQ(caustics_picture(caustics).data, first.data);
  caustics.time = 1;
  EXPECT_NE(caustics_picture(caustics).data, first.data);
}

TEST(Caustics, AddNoLight) {
  // The brightness of a plain surface is 0.125 / 1.13; light that is gathered here is missing there.
  Raster picture = caustics_picture({.pixels = 128});
  double sum = 0;
  for (std::uint8_t level : picture.data) sum += std::pow(level / 255.0, 2);
  EXPECT_NEAR(sum / static_cast<double>(picture.data.size()) / (0.125 / 1.13), 1, 0.35);
}

}  // namespace
}  // namespace frond
