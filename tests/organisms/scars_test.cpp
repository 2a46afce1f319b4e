#include <gtest/gtest.h>

#include "organisms/body_colony.h"

namespace frond {
namespace {

/// A level skin of a square metre.
Surface level() {
  constexpr std::uint32_t kRows = 41;
  Surface skin;
  for (std::uint32_t j = 0; j < kRows; ++j)
    for (std::uint32_t i = 0; i < kRows; ++i)
      skin.position.push_back({i / (kRows - 1.0), 0, -(j / (kRows - 1.0))});
  stitch_rows(skin, 0, kRows, kRows);
  set_normals(skin);
  return skin;
}

TEST(Scars, TakeTheirShareOfTheSkin) {
  Surface skin = level();
  EXPECT_TRUE(dead_patches({}, skin, Seed{1}).empty()) << "a colony lives unless it is said to have died";
  TissueLook look;
  look.dead = 0.2, look.scars = 4;
  double all = 0;
  constexpr int kColonies = 200;
  for (std::uint64_t s = 0; s < kColonies; ++s) {
    std::vector<DeadPatch> patches = dead_patches(look, skin, Seed{s});
    ASSERT_EQ(patches.size(), 4u);
    for (const DeadPatch& p : patches) {
      all += kPi * static_cast<double>(p.radius) * static_cast<double>(p.radius);
      EXPECT_GE(p.at.x, 0);
      EXPECT_LE(p.at.x, 1);
    }
  }
  EXPECT_NEAR(all / kColonies, look.dead, 0.03);
}

TEST(Scars, AreLeftOutWhereTheyAreTooSmallToShow) {
  TissueLook look;
  look.dead = 1e-9, look.scars = 12;
  EXPECT_TRUE(dead_patches(look, level(), Seed{1}).empty());
}

TEST(Scars, DifferFromColonyToColony) {
  Surface skin = level();
  TissueLook look;
  look.dead = 0.2;
  EXPECT_EQ(dead_patches(look, skin, Seed{1})[0].at, dead_patches(look, skin, Seed{1})[0].at);
  EXPECT_NE(dead_patches(look, skin, Seed{1})[0].at, dead_patches(look, skin, Seed{2})[0].at);
}

}  // namespace
}  // namespace frond
