#include "grove/light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/parallel.h"
#include "core/seed.h"

namespace frond {
namespace {

LightLaw law_of(Fading fading) {
  LightLaw law;
  law.fading = fading;
  law.depth = 6;
  law.base = fading == Fading::diffuse ? 1.05 : 1.5;
  return law;
}

/// The middle of a cell.
Vec3 middle(int x, int y, int z) {
  return Vec3(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, static_cast<float>(z) + 0.5f) *
         0.5f;
}

std::vector<Shade> cloud(int count) {
  std::vector<Shade> list;
  for (int i = 0; i < count; ++i) {
    Seed s = Seed{7}.child(static_cast<std::uint64_t>(i));
    list.push_back(
        {Vec3(static_cast<float>(s.child(0).range(-20, 20)), static_cast<float>(s.child(1).range(1, 12)),
              static_cast<float>(s.child(2).range(-20, 20))),
         0.05f});
  }
  return list;
}

/// The pyramid of Palubicki et al.: cell by cell what its law says, from the source alone.
TEST(Light, APyramidFadesByLayers) {
  LightField field(law_of(Fading::geometric));
  field.cast({{middle(3, 20, -2), 0.4f}}, 0);
  for (int y = 10; y <= 22; ++y) {
    for (int x = -6; x <= 12; ++x) {
      for (int z = -11; z <= 7; ++z) {
        int q = 20 - y;
        bool inside = q >= 0 && q <= 6 && std::abs(x - 3) <= q && std::abs(z + 2) <= q;
        float expected = inside ? 0.4f * static_cast<float>(std::pow(1.5, -q)) : 0.0f;
        ASSERT_NEAR(field.shadow(middle(x, y, z)), expected, 1e-6) << x << ' ' << y << ' ' << z;
      }
    }
  }
}

TEST(Light, APyramidOfVolumeFadesEvenly) {
  LightField field(law_of(Fading::even));
  field.cast({{middle(0, 20, 0), 0.7f}}, 0);
  for (int q = 0; q <= 6; ++q)
    EXPECT_NEAR(field.shadow(middle(q, 20 - q, -q)), 0.7f * (1 - static_cast<float>(q) / 7), 1e-6);
  EXPECT_EQ(field.shadow(middle(0, 13, 0)), 0);
  LightLaw law = law_of(Fading::even);
  EXPECT_GT(shade_amount(law, 0, 0.02), 1.9f * shade_amount(law, 0, 0.01)) << "wood fills its cell";
  EXPECT_EQ(shade_amount(law_of(Fading::geometric), 0, 0.02), 0);
}

/// Diffuse shade loses only what the law takes, whatever tiles it crosses; under a wide roof it is the
/// roof's.
TEST(Light, DiffuseShadeIsKept) {
  LightLaw law = law_of(Fading::diffuse);
  law.base = 1;
  LightField field(law);
  field.cast({{middle(15, 24, 0), 3.0f}}, 0);
  for (int y : {24, 18, 9, 0}) {
    double sum = 0;
    for (int x = -20; x <= 50; ++x)
      for (int z = -35; z <= 35; ++z) sum += field.shadow(middle(x, y, z));
    EXPECT_NEAR(sum, 3, 0.12) << "layer " << y;
  }
  law.base = 1.1;
  LightField roof(law);
  std::vector<Shade> leaves;
  for (int x = -30; x < 30; ++x)
    for (int z = -30; z < 30; ++z) leaves.push_back({middle(x, 20, z), 0.5f});
  roof.cast(leaves, 0);
  EXPECT_NEAR(roof.shadow(middle(0, 10, 0)), 0.5 * std::pow(1.1, -10), 1e-3);
}

TEST(Light, TheSlopeLeadsOutOfTheShade) {
  LightField field(law_of(Fading::diffuse));
  std::vector<Shade> wall;
  for (int z = -12; z < 12; ++z)
    for (int y = 0; y < 16; ++y) wall.push_back({middle(-2, y, z), 0.5f});
  field.cast(wall, 0);
  Vec3 slope = field.gradient(Vec3(0, 3, 0));
  EXPECT_LT(slope.x, -0.05f) << "the shadow grows toward the wall";
  EXPECT_LT(std::abs(slope.z), 0.02f);
  // Between the middles of cells the shadow has no steps.
  float last = field.shadow(Vec3(-1.5f, 3, 0.1f));
  for (float x = -1.5f; x < 2; x += 0.02f) {
    float now = field.shadow(Vec3(x, 3, 0.1f));
    EXPECT_LT(std::abs(now - last), 0.12f);
    last = now;
  }
}

TEST(Light, AnEmptyFieldIsBright) {
  LightField field{LightLaw{}};
  EXPECT_EQ(field.shadow(Vec3(1, 2, 3)), 0);
  field.cast(cloud(10), 0);
  field.cast({}, 0);
  EXPECT_EQ(field.shadow(Vec3(0, 1, 0)), 0);
}

TEST(Light, ManyThreadsCastTheSameShadow) {
  for (Fading fading : {Fading::diffuse, Fading::geometric, Fading::even}) {
    LightField one(law_of(fading)), many(law_of(fading));
    limit_threads(1);
    one.cast(cloud(3000), 0);
    limit_threads(2);
    many.cast(cloud(3000), 0);
    limit_threads(0);
    for (const Shade& s : cloud(300)) {
      Vec3 at = s.at - Vec3(0.3f, 1.2f, 0.1f);
      EXPECT_EQ(one.shadow(at), many.shadow(at));
    }
  }
}

/// Land between trees costs nothing but the directory.
TEST(Light, TheGridIsSparse) {
  LightField near(LightLaw{}), far(LightLaw{});
  near.cast({{Vec3(0, 10, 0), 1}, {Vec3(8, 10, 0), 1}}, 0);
  far.cast({{Vec3(0, 10, 0), 1}, {Vec3(800, 10, 0), 1}}, 0);
  EXPECT_LT(far.tiles(), 3 * near.tiles() + 50);
}

}  // namespace
}  // namespace frond
