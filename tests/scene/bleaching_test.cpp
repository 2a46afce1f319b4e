#include "scene/bleaching.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/files.h"

namespace frond {
namespace {

TEST(Bleaching, ExportsAndPicturesKnowTheSameNumbers) {
  std::string macros = *read_file(FROND_ROOT "/povinc/frond_bleach.inc");
  auto declares = [&](const std::string& text) { return macros.find("#declare " + text) != macros.npos; };
  auto vector = [](Vec3 v) { return fmt::format("<{:.2f}, {:.2f}, {:.2f}>", v.x, v.y, v.z); };
  EXPECT_TRUE(declares(fmt::format("Bleach_Dead_Light = {:.2f};", kDeadLight)));
  EXPECT_TRUE(declares(fmt::format("Bleach_Pale_Light = {:.2f};", kPaleLight)));
  EXPECT_TRUE(declares(fmt::format("Bleach_Living_Light = {:.2f};", kLivingLight)));
  EXPECT_TRUE(declares("Bleach_Lime = " + vector(kBleachedLime)));
  EXPECT_TRUE(declares("Bleach_Turf = " + vector(kDeadTurf)));
}

TEST(Bleaching, SkinGoesFromDeadOverPaleToItsOwnColour) {
  Vec3 color(0.5f, 0.25f, 0.1f);
  EXPECT_EQ(bleached(color, kLivingLight), color);
  float pale = glm::length(bleached(color, kPaleLight));
  EXPECT_GT(pale, glm::length(color));
  EXPECT_GT(pale, glm::length(bleached(color, kDeadLight)));
}

}  // namespace
}  // namespace frond
