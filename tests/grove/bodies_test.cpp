#include "grove/bodies.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solids.h"

namespace frond {
namespace {

float light_beside(const std::vector<Shade>& shades, const LightLaw& law, Vec3 at, Vec3 offset = Vec3(0)) {
  LightField field(law);
  field.cast(shades, 0, offset);
  return std::exp(-field.shadow(at));
}

TEST(Bodies, AWallTakesAboutHalfOfTheLightHoweverThickItIs) {
  for (float thick : {0.1f, 0.24f, 0.5f, 2.0f}) {
    for (double voxel : {0.3, 0.5}) {
      LightLaw law;
      law.voxel = voxel;
      std::vector<Shade> wall = shades_of_body(box(Vec3(-0.5f - thick, 0, -10), Vec3(-0.5f, 12, 10)), law);
      for (float shift : {0.0f, 0.5f}) {
        float near = light_beside(wall, law, Vec3(0, 1, 0), Vec3(shift));
        EXPECT_GT(near, 0.25f) << thick << " m thick, cells of " << voxel << " m";
        EXPECT_LT(near, 0.65f) << thick << " m thick, cells of " << voxel << " m";
      }
      EXPECT_GT(light_beside(wall, law, Vec3(8, 1, 0)), 0.95f);
      EXPECT_GT(light_beside(wall, law, Vec3(0, 13.1f, 0)), 0.99f) << "above it";
    }
  }
}

TEST(Bodies, TakeLightWhateverTheLaw) {
  for (Fading fading : {Fading::geometric, Fading::even}) {
    LightLaw law;
    law.fading = fading;
    law.base = 1.5;
    std::vector<Shade> wall = shades_of_body(box(Vec3(-0.8f, 0, -10), Vec3(-0.5f, 12, 10)), law);
    float near = light_beside(wall, law, Vec3(0, 1, 0));
    EXPECT_GT(near, 0.2f);
    EXPECT_LT(near, 0.7f);
  }
}

TEST(Bodies, ARoofTakesMoreThanAPebble) {
  LightLaw law;
  std::vector<Shade> roof = shades_of_body(box(Vec3(-6, 4, -6), Vec3(6, 4.2f, 6)), law);
  EXPECT_LT(light_beside(roof, law, Vec3(0, 2, 0)), 0.35f);
  std::vector<Shade> pebble = shades_of_body(box(Vec3(0, 0, 0), Vec3(0.1f, 0.1f, 0.1f)), law);
  EXPECT_FALSE(pebble.empty());
  EXPECT_GT(light_beside(pebble, law, Vec3(0.25f, 0.25f, 0.25f)), 0.6f);
}

TEST(Bodies, AreFullInside) {
  // What lies within casts nothing: a box of boxes shades as the outermost.
  LightLaw law;
  Surface outer = box(Vec3(0), Vec3(4)), both = outer, inner = box(Vec3(1), Vec3(3));
  both.position.insert(both.position.end(), inner.position.begin(), inner.position.end());
  for (auto [a, b, c] : inner.triangle) both.triangle.push_back({a + 8, b + 8, c + 8});
  std::vector<Shade> one = shades_of_body(outer, law), two = shades_of_body(both, law);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].amount, two[i].amount);
}

TEST(Bodies, MayBeNothingOrVeryLarge) {
  EXPECT_TRUE(shades_of_body({}, {}).empty());
  EXPECT_LT(shades_of_body(box(Vec3(-3000, -1, -3000), Vec3(3000, 0, 3000)), {}).size(), 1u << 24);
}

}  // namespace
}  // namespace frond
