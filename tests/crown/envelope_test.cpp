#include "crown/envelope.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rocks/stone.h"

namespace frond {
namespace {

/// The share of a box's volume that an envelope takes.
double volume(const Envelope& e) {
  Vec3 size = e.high() - e.low();
  int in = 0, all = 40000;
  for (int i = 0; i < all; ++i) {
    Seed s = Seed{3}.child(static_cast<std::uint64_t>(i));
    in += e.inside(e.low() + size * Vec3(s.child(0).unit(), s.child(1).unit(), s.child(2).unit()));
  }
  return static_cast<double>(size.x) * size.y * size.z * in / all;
}

TEST(Envelope, HasTheVolumeOfItsShape) {
  EXPECT_NEAR(volume(Envelope(EllipsoidCrown{{0, 4, 0}, {1, 2, 3}})), 4 / 3.0 * kPi * 6, 0.5);
  EXPECT_NEAR(volume(Envelope(ConeCrown{{0, 1, 0}, 3, 2, 0})), kPi * 4 * 3 / 3, 0.3);
  EXPECT_NEAR(volume(Envelope(ConeCrown{{0, 1, 0}, 3, 1, 1})), kPi * 3, 0.2);
  // A triangle turned is a cone, and with a depth a roof.
  Result<Silhouette> triangle = Silhouette::from_outlines({{Vec2(-1, 0), Vec2(1, 0), Vec2(0, 2)}});
  ASSERT_TRUE(triangle.ok());
  EXPECT_NEAR(volume(Envelope(SilhouetteCrown{*triangle, {0, 0, 0}, 4, 0})), kPi * 4 * 4 / 3, 0.6);
  EXPECT_NEAR(volume(Envelope(SilhouetteCrown{*triangle, {0, 0, 0}, 4, 1.5})), 4 * 4 / 2.0 * 1.5, 0.4);
}

TEST(Envelope, AMeshIsAskedByRays) {
  Stone stone{Seed{4}};
  Envelope e(MeshCrown{stone_surface(stone, 5)});
  for (int i = 0; i < 3000; ++i) {
    Seed s = Seed{5}.child(static_cast<std::uint64_t>(i));
    Vec3 d(s.child(0).normal(), s.child(1).normal(), s.child(2).normal());
    Vec3 rim = stone_surface_point(stone, d);
    EXPECT_TRUE(e.inside(rim * 0.96f)) << i;
    EXPECT_FALSE(e.inside(rim * 1.04f)) << i;
  }
}

TEST(Envelope, SamplesLieInsideAndEvenly) {
  Envelope e(EllipsoidCrown{{0, 4, 0}, {2, 2, 2}});
  std::vector<Vec3> places = e.sample(8000, Seed{1});
  ASSERT_EQ(places.size(), 8000u);
  int upper = 0, core = 0;
  for (Vec3 p : places) {
    EXPECT_TRUE(e.inside(p));
    upper += p.y > 4;
    core += glm::distance(p, Vec3(0, 4, 0)) < 1;
  }
  EXPECT_NEAR(upper, 4000, 200);
  EXPECT_NEAR(core, 1000, 120);
}

}  // namespace
}  // namespace frond
