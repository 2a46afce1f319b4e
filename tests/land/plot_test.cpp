#include "land/plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "land/ground.h"

namespace frond {
namespace {

Plot plot() {
  PondShape pond{{1, -2}, {4, 2.5}};
  PathShape path{{Vec2(-6, 4), Vec2(0, 3), Vec2(6, 5)}, 1.2};
  return Plot(pond, path, Seed{3});
}

Vec2 somewhere(int i) {
  Seed seed = Seed{11}.child(static_cast<std::uint64_t>(i));
  return Vec2(seed.child(0).range(-9, 9), seed.child(1).range(-9, 9));
}

TEST(Plot, ThePondHoldsItsWater) {
  Plot p = plot();
  Ground dunes{Seed{5}, 0.6, 3};
  int wet = 0;
  for (int i = 0; i < 4000; ++i) {
    Vec2 at = somewhere(i);
    double height = p.height(at, ground_height(dunes, at.x, at.y)), level = p.pond().level;
    double away = p.pond_distance(at);
    if (away > 0.4) {
      EXPECT_GT(height, level) << "a puddle";
    }
    if (away < -1.3) {
      EXPECT_NEAR(height, level - p.pond().depth + 0.07, 0.15);
    }
    wet += height < level;
  }
  // About the ellipse's share of the square.
  EXPECT_NEAR(wet / 4000.0, kPi * 4 * 2.5 / (18 * 18), 0.03);
}

TEST(Plot, DistancesAreAboutTrue) {
  Plot p = plot();
  for (int i = 0; i < 1000; ++i) {
    Vec2 at = somewhere(i);
    // Nothing gets farther away than one goes.
    Vec2 next = at + Vec2(0.01f, 0.007f);
    EXPECT_LT(std::abs(p.path_distance(at) - p.path_distance(next)), 0.05);
    EXPECT_LT(std::abs(p.pond_distance(at) - p.pond_distance(next)), 0.05);
  }
  EXPECT_LT(p.path_distance({0, 3}), -0.3);  // on a point that it leads through
  EXPECT_GT(p.path_distance({0, 4}), 0.2);
  EXPECT_LT(p.path_distance({6, 5}), -0.3);
  EXPECT_GT(Plot().pond_distance({0, 0}), 1000);
  EXPECT_GT(Plot().path_distance({0, 0}), 1000);
}

TEST(Plot, AreasHaveStraightEdges) {
  Plot p({}, {}, Seed{3},
         {{GroundArea::Kind::gravel, {0, 0}, {4, 1}}, {GroundArea::Kind::earth, {0, 3}, {2, 2}}});
  EXPECT_TRUE(p.has_path());
  EXPECT_TRUE(p.has_earth());
  for (int i = 0; i < 1000; ++i) {
    Vec2 at = somewhere(i);
    bool gravel = std::abs(at.x) < 2 && std::abs(at.y) < 0.5f,
         earth = std::abs(at.x) < 1 && std::abs(at.y - 3) < 1;
    double to_gravel = p.path_distance(at), to_earth = p.earth_distance(at);
    EXPECT_TRUE(std::abs(to_gravel) < 0.03 || (to_gravel < 0) == gravel);
    EXPECT_TRUE(std::abs(to_earth) < 0.03 || (to_earth < 0) == earth);
  }
  EXPECT_NEAR(p.path_distance({5, 0}), 3, 1e-5);
  EXPECT_GT(p.height({0, 3}, 0.1), 0.1) << "a bed is raised";
  EXPECT_FALSE(Plot().has_earth());
}

TEST(Plot, AreasMayHaveAnyOutline) {
  // A square without its corner, drawn either way round.
  std::vector<SplinePoint<Vec2>> outline{Vec2(-2, -2), Vec2(2, -2), Vec2(2, 0),
                                         Vec2(0, 0),   Vec2(0, 2),  Vec2(-2, 2)};
  for (bool turned : {false, true}) {
    if (turned) std::ranges::reverse(outline);
    Plot p({}, {}, Seed{3}, {{GroundArea::Kind::earth, {}, {}, outline}});
    for (int i = 0; i < 1000; ++i) {
      Vec2 at = somewhere(i) / 3.0f;
      bool within = std::abs(at.x) < 2 && std::abs(at.y) < 2 && !(at.x > 0 && at.y > 0);
      double away = p.earth_distance(at);
      EXPECT_TRUE(std::abs(away) < 0.03 || (away < 0) == within) << at.x << " " << at.y;
    }
    EXPECT_NEAR(p.earth_distance({5, -1}), 3, 1e-5);
    EXPECT_NEAR(p.earth_distance({1, 5}), std::hypot(1, 3), 1e-5);
  }
  EXPECT_EQ((GroundArea{GroundArea::Kind::earth, {}, {}, outline}.box()),
            (std::array<Vec2, 2>{Vec2(-2), Vec2(2)}));
}

TEST(Plot, LiliesFloatOnTheirPondApartFromEachOther) {
  Plot p = plot();
  Solids lilies = water_lilies(p, 50, Seed{1});
  EXPECT_EQ(lilies.find_fault(), "");
  std::size_t pads = 0;
  for (std::size_t i = 0; i < lilies.size(); ++i) {
    Vec2 at(lilies.position[i].x, lilies.position[i].z);
    EXPECT_LT(p.pond_distance(at), -0.2);
    if (lilies.shape[i] > 2) continue;
    ++pads;
    for (std::size_t j = 0; j < i; ++j) {
      if (lilies.shape[j] > 2) continue;
      Vec2 other(lilies.position[j].x, lilies.position[j].z);
      EXPECT_GT(glm::distance(at, other), 0.45f * (lilies.scale[i].x + lilies.scale[j].x));
    }
  }
  EXPECT_GT(pads, 35u);
  EXPECT_EQ(water_lilies(Plot(), 50, Seed{1}).size(), 0u);
}

TEST(Gravel, CoversItsSquare) {
  Surface gravel = gravel_surface(0.5, 0.05, Seed{2});
  EXPECT_EQ(gravel.find_fault(), "");
  std::array<bool, 100> covered{};
  for (Vec3 p : gravel.position) {
    int column = static_cast<int>(std::floor((p.x + 0.25f) * 20)),
        row = static_cast<int>(std::floor((p.z + 0.25f) * 20));
    if (column >= 0 && column < 10 && row >= 0 && row < 10)
      covered[static_cast<std::size_t>(10 * row + column)] = true;
    EXPECT_LT(std::abs(p.x), 0.29f);
  }
  for (bool here : covered) EXPECT_TRUE(here);
}

TEST(Heights, AreThoseOfTheMesh) {
  Ground dunes{Seed{5}, 0.6, 3};
  Surface floor = ground_surface(dunes, Vec2(0), {100, 40});
  Heights heights(floor);
  for (std::size_t i = 0; i < floor.position.size(); i += 7) {
    const Vec3& p = floor.position[i];
    if (std::hypot(p.x, p.z) > 95) continue;
    EXPECT_NEAR(heights(p.x, p.z), p.y, 1e-4) << p.x << ' ' << p.z;
  }
  EXPECT_EQ(heights(200, 0), 0);
}

}  // namespace
}  // namespace frond
