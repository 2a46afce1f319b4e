#include "draw/surfel_sampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace frond {
namespace {

using Triangles = std::vector<std::array<Vec3, 3>>;

/// A square, one unit wide, in a plane that lies anyhow.
Triangles square(Vec3 at, Vec3 along, Vec3 across) {
  return {{at, at + along, at + across}, {at + along, at + along + across, at + across}};
}

TEST(ApartArea, OfAFlatLeafIsItsArea) {
  EXPECT_NEAR(apart_area(square(Vec3(0), Vec3(0.6f, 0.8f, 0), Vec3(0, 0, 1))), 1, 0.1);
}

TEST(ApartArea, CountsLeavesThatLieOnOneAnotherOnce) {
  Triangles leaves;
  for (int i = 0; i < 5; ++i)
    for (const auto& t : square(Vec3(0, 0.001f * static_cast<float>(i), 0), Vec3(1, 0, 0), Vec3(0, 0, 1)))
      leaves.push_back(t);
  EXPECT_NEAR(apart_area(leaves), 1, 0.1);
}

TEST(ApartArea, OfABodyIsHalfItsSkin) {
  // Cauchy's formula: the mean shadow of a convex body is a quarter of its skin.
  Triangles cube;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 a(0), b(0), c(0);
    a[axis] = b[(axis + 1) % 3] = c[(axis + 2) % 3] = 1;
    for (Vec3 at : {Vec3(0), a})
      for (const auto& t : square(at, b, c)) cube.push_back(t);
  }
  EXPECT_NEAR(apart_area(cube), 3, 0.15);
}

struct Areas {
  float wide;
  std::vector<float>& areas;
  float step(Vec3) const { return wide; }
  void add(Vec3, float area, Vec3, Facing, float) const { areas.push_back(area); }
};

struct Places {
  float wide;
  std::vector<Vec3>& places;
  float step(Vec3) const { return wide; }
  void add(Vec3 at, float, Vec3, Facing, float) const { places.push_back(at); }
};

/// A specimen that is one organ of one unit.
Specimen lone(const OrganPart& part) {
  Specimen herb;
  herb.model.prototypes = {{"leaf", {part}, {Color{0, 1, 0}}, Color{0, 1, 0}}};
  Organs& o = herb.model.organs;
  o.prototype = {0}, o.position = {Vec3(0)}, o.turn = {Quat(1, 0, 0, 0)}, o.scale = {Vec3(1)};
  o.node = {Skeleton::kRoot}, o.birth = {0}, o.color = {0}, o.id = {1};
  return herb;
}

TEST(SurfelSampler, TrianglesThatAreMuchLargerThanAStepAreCoveredWithoutHoles) {
  OrganPart part;
  for (const auto& t : square(Vec3(0), Vec3(1, 0, 0), Vec3(0, 0, 1))) {
    auto first = static_cast<std::uint32_t>(part.surface.position.size());
    for (const Vec3& p : t) part.surface.position.push_back(p);
    part.surface.triangle.push_back({first, first + 1, first + 2});
  }
  Specimen leaf = lone(part);
  std::vector<Vec3> places;
  sample_surfels(Places{0.02f, places}, DrawList(leaf, leaf.model));
  for (int x = 0; x < 10; ++x)
    for (int z = 0; z < 10; ++z)
      EXPECT_TRUE(std::ranges::any_of(
          places, [&](Vec3 p) { return static_cast<int>(10 * p.x) == x && static_cast<int>(10 * p.z) == z; }))
          << x << ' ' << z;
}

TEST(SurfelSampler, ASinkGetsNoMoreBitsOfALeafThanItsStepAsksFor) {
  OrganPart part;  // a leaf of one unit, in 800 triangles
  for (int i = 0; i < 400; ++i)
    for (const auto& t :
         square(Vec3(0.05f * static_cast<float>(i % 20), 0, 0.05f * static_cast<float>(i / 20)),
                Vec3(0.05f, 0, 0), Vec3(0, 0, 0.05f))) {
      auto first = static_cast<std::uint32_t>(part.surface.position.size());
      for (const Vec3& p : t) part.surface.position.push_back(p);
      part.surface.triangle.push_back({first, first + 1, first + 2});
    }
  Specimen herb = lone(part);
  auto bits_of = [&](const Areas& sink) { sample_surfels(sink, DrawList(herb, herb.model)); };
  std::vector<float> all, few;
  bits_of({0.03f, all});
  bits_of({0.1f, few});
  EXPECT_EQ(all.size(), 800u);
  EXPECT_LE(few.size(), 120u) << "a hundred steps cover it";
  EXPECT_GE(few.size(), 90u);
  EXPECT_NEAR(std::accumulate(few.begin(), few.end(), 0.0f), std::accumulate(all.begin(), all.end(), 0.0f),
              1e-3)
      << "each bit has the area of those that it stands for";
}

}  // namespace
}  // namespace frond
