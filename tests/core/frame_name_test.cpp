#include "core/frame_name.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

TEST(FrameName, HasFourDigitsOrMore) {
  EXPECT_EQ(frame_name(1), "frame_0001");
  EXPECT_EQ(frame_name(9999), "frame_9999");
  EXPECT_EQ(frame_name(12345), "frame_12345");
}

TEST(FrameName, TheFirstExposureBearsThatOfTheFrame) {
  EXPECT_EQ(exposure_name(7, 0), "frame_0007");
  EXPECT_EQ(exposure_name(7, 1), "frame_0007");
  EXPECT_EQ(exposure_name(7, 2), "frame_0007_s2");
}

}  // namespace
}  // namespace frond
