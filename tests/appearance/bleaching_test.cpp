#include "appearance/bleaching.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

TEST(Bleaching, SkinGoesFromDeadOverPaleToItsOwnColour) {
  Vec3 color(0.5f, 0.25f, 0.1f);
  EXPECT_EQ(starved_color(color, kBleaching.living_light), color);
  float pale = glm::length(starved_color(color, kBleaching.pale_light));
  EXPECT_GT(pale, glm::length(color));
  EXPECT_GT(pale, glm::length(starved_color(color, kBleaching.dead_light)));
}

}  // namespace
}  // namespace frond
