#include "core/triangle.h"

#include <gtest/gtest.h>

#include "core/discrete_distribution.h"
#include "core/seed.h"

namespace frond {
namespace {

TEST(Triangle, PlacesAreDrawnAllOverByArea) {
  // A square of two triangles, and between them one that is a line.
  const Vec3 corner[3][3] = {{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}},
                             {{0, 0, 0}, {1, 0, 1}, {2, 0, 2}},
                             {{0, 0, 0}, {1, 0, 1}, {0, 0, 1}}};
  DiscreteDistribution lots;
  for (const auto& [a, b, c] : corner) lots.add(triangle_area(a, b, c));
  EXPECT_NEAR(lots.sum(), 1, 1e-6);
  constexpr int kDraws = 40000, kSide = 4;
  int held[kSide][kSide] = {};
  for (std::uint64_t i = 0; i < kDraws; ++i) {
    Seed own = Seed{5}.child(i);
    std::size_t t = lots.drawn(own.child(0).unit());
    ASSERT_TRUE(t == 0 || t == 2);
    DVec3 w = drawn_weights(own.child(1).unit(), own.child(2).unit());
    EXPECT_NEAR(w.x + w.y + w.z, 1, 1e-12);
    const auto& [a, b, c] = corner[t];
    Vec3 at = a * static_cast<float>(w.x) + b * static_cast<float>(w.y) + c * static_cast<float>(w.z);
    auto cell = [](float x) { return std::min(kSide - 1, static_cast<int>(x * kSide)); };
    ++held[cell(at.x)][cell(at.z)];
  }
  for (const auto& row : held)
    for (int n : row) EXPECT_NEAR(n, kDraws / (kSide * kSide), 250);
}

TEST(Triangle, IsWalkedInSteps) {
  Vec3 a(0), b(2, 0, 0), c(0, 1, 0);
  std::vector<Vec3> places;
  over_triangle(a, b, c, 0.25f, [&](Vec3 at) { places.push_back(at); });
  for (std::uint64_t i = 0; i < 500; ++i) {
    Vec3 w(drawn_weights(Seed{2}.child(i).child(0).unit(), Seed{2}.child(i).child(1).unit()));
    Vec3 at = a * w.x + b * w.y + c * w.z;
    EXPECT_TRUE(std::ranges::any_of(places, [&](Vec3 p) { return glm::distance(p, at) <= 0.25f; }));
  }
  for (Vec3 corner : {a, b, c})
    EXPECT_TRUE(std::ranges::any_of(places, [&](Vec3 p) { return glm::distance(p, corner) < 1e-6f; }));
  std::size_t few = 0;
  over_triangle(a, b, c, 9, [&](Vec3) { ++few; });
  EXPECT_EQ(few, 3u);
}

}  // namespace
}  // namespace frond
