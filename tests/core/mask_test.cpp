#include "core/mask.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

/// Brighter to the right and, less, downward.
Mask ramp() {
  Mask mask;
  mask.width = mask.height = 4;
  std::vector<float> grey;
  for (int i = 0; i < 16; ++i)
    grey.push_back(0.2f * static_cast<float>(i % 4) + 0.1f * static_cast<float>(i / 4));
  mask.grey = std::make_shared<const std::vector<float>>(grey);
  mask.area = {Vec2(2, 3), Vec2(-2, 1)};  // any two opposite corners
  return mask;
}

TEST(Mask, IsBilinearAndGoesOnBeyondItsEdges) {
  Mask mask = ramp();
  EXPECT_NEAR(mask.at_share(0.125, 0.125), 0, 1e-6);
  EXPECT_NEAR(mask.at_share(0.5, 0.5), 0.45, 1e-6);
  EXPECT_NEAR(mask.at_share(0.875, 0.875), 0.9, 1e-6);
  EXPECT_EQ(mask.at_share(-5, 7), mask.at_share(0, 1));
  for (int i = 0; i < 1000; ++i) {
    double x = i / 1000.0;
    EXPECT_NEAR(mask.at_share(x, 0.3), mask.at_share(x + 0.001, 0.3), 0.001) << "no step anywhere";
  }
}

TEST(Mask, WithoutAPictureIsOne) { EXPECT_EQ(Mask{}.at(DVec3(1, 2, 3), DVec3(0), DVec3(1)), 1); }

TEST(Mask, LiesAlongItsAxisAsOneSeesIt) {
  Mask mask = ramp();
  auto at = [&](Axis axis, DVec3 place) {
    mask.along = axis;
    return mask.at(place, DVec3(0), DVec3(0));
  };
  for (double away : {-9.0, 0.0, 40.0}) {
    EXPECT_NEAR(at(Axis::z, {-2, 3, away}), mask.at_share(0, 0), 1e-6) << "its top is above";
    EXPECT_NEAR(at(Axis::z, {1, 1.5, away}), mask.at_share(0.75, 0.75), 1e-6);
    EXPECT_NEAR(at(Axis::y, {1, away, 1.5}), mask.at_share(0.75, 0.25), 1e-6) << "its top is the lower z";
    EXPECT_NEAR(at(Axis::x, {away, 1.5, 1}), mask.at_share(0.75, 0.75), 1e-6);
  }
}

TEST(Mask, WithoutAnAreaCoversWhatItIsLaidOn) {
  Mask mask = ramp();
  mask.area.clear();
  EXPECT_NEAR(mask.on_land(Vec2(-50, -50), 100), mask.at_share(0, 0), 1e-6);
  EXPECT_NEAR(mask.on_land(Vec2(25, 0), 100), mask.at_share(0.75, 0.5), 1e-6);
  mask.along = Axis::z;
  EXPECT_NEAR(mask.at(DVec3(3, 1, 0), DVec3(0), DVec3(4)), mask.at_share(0.75, 0.75), 1e-6);
}

}  // namespace
}  // namespace frond
