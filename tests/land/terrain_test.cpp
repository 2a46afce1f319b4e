#include "land/terrain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frond {
namespace {

TerrainShape shape_of(double rough) {
  TerrainShape shape;
  shape.rough = rough;
  shape.path = {{Vec2(-70, 10), Vec2(-30, -12), Vec2(5, 4), Vec2(40, -6), Vec2(75, 20)}, 2};
  return shape;
}

Vec2 somewhere(int i, double half) {
  Seed seed = Seed{17}.child(static_cast<std::uint64_t>(i));
  return Vec2(seed.child(0).range(-half, half), seed.child(1).range(-half, half));
}

/// Rise over run along x and z, over more than a cell.
Vec2 slope_at(const Terrain& land, Vec2 at) {
  return Vec2(land.height(at.x + 0.75, at.y) - land.height(at.x - 0.75, at.y),
              land.height(at.x, at.y + 0.75) - land.height(at.x, at.y - 0.75)) /
         1.5f;
}

double steepness(const Terrain& land, Vec2 at) { return std::atan(glm::length(slope_at(land, at))); }

TEST(Terrain, IsTheMeshThatIsDrawn) {
  Terrain land(shape_of(0.6), Seed{1});
  Surface mesh = land.surface();
  ASSERT_EQ(mesh.find_fault(), "");
  EXPECT_LT(mesh.position.size(), 310u * 310u);
  for (std::size_t i = 0; i < mesh.position.size(); i += 31) {
    const Vec3& p = mesh.position[i];
    EXPECT_FLOAT_EQ(static_cast<float>(land.height(p.x, p.z)), p.y);
  }
  // Anywhere in a triangle, too.
  for (std::size_t i = 0; i < mesh.triangle.size(); i += 37) {
    auto [a, b, c] = mesh.triangle[i];
    Vec2 share = somewhere(static_cast<int>(i), 0.5) + 0.5f;
    if (share.x + share.y > 1) share = 1.0f - share;
    Vec3 p = mesh.position[a] + share.x * (mesh.position[b] - mesh.position[a]) +
             share.y * (mesh.position[c] - mesh.position[a]);
    EXPECT_NEAR(land.height(p.x, p.z), p.y, 2e-3) << p.x << ' ' << p.z;
    EXPECT_GT(glm::cross(mesh.position[b] - mesh.position[a], mesh.position[c] - mesh.position[a]).y, 0);
  }
}

TEST(Terrain, GoesOnToTheHorizonWithoutACliff) {
  Terrain land(shape_of(0.4), Seed{2});
  EXPECT_GE(land.reach(), 1199);
  EXPECT_EQ(land.height(5000, 0), land.height(land.reach(), 0));
  double far = 0;
  for (int i = 0; i < 4000; ++i) {
    Vec2 at = somewhere(i, land.reach());
    EXPECT_LT(steepness(land, at), radians(50.0)) << at.x << ' ' << at.y;
    if (glm::length(at) > 400) far = std::max(far, land.height(at.x, at.y) - land.height(0, 0));
  }
  EXPECT_GT(far, 8) << "hills";
}

TEST(Terrain, IsSmooth) {
  Terrain land(shape_of(0.3), Seed{3});
  for (int i = 0; i < 4000; ++i) {
    Vec2 at = somewhere(i, 79);
    EXPECT_NEAR(land.height(at.x, at.y), land.height(at.x + 1e-3, at.y - 1e-3), 5e-3);
  }
  // Over more than a cell the slope of the normals is that of the heights.
  Surface mesh = land.surface();
  for (std::size_t i = 0; i < mesh.position.size(); i += 7) {
    const Vec3 &p = mesh.position[i], &n = mesh.normal[i];
    if (std::max(std::abs(p.x), std::abs(p.z)) > 79) continue;
    Vec2 slope = slope_at(land, {p.x, p.z});
    EXPECT_NEAR(-n.x / n.y, slope.x, 0.06);
    EXPECT_NEAR(-n.z / n.y, slope.y, 0.06);
  }
}

TEST(Terrain, RisesByItsHills) {
  for (double rough : {0.0, 1.0})
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      TerrainShape shape;
      shape.rough = rough;
      Terrain land(shape, Seed{seed});
      double low = 1e9, high = -1e9, steep = 0;
      for (int i = 0; i < 6000; ++i) {
        Vec2 at = somewhere(i, 80);
        double h = land.height(at.x, at.y);
        low = std::min(low, h), high = std::max(high, h);
        steep += steepness(land, at) / 6000;
      }
      EXPECT_GT(high - low, 0.9 * shape.hills) << seed;
      EXPECT_LT(high - low, 1.1 * shape.hills) << seed;
      EXPECT_NEAR(land.height(0, 0), 0, 1e-5);
      // 8 m in 35: steeper than a plain, nowhere near a rock face.
      EXPECT_GT(steep, radians(2.0)) << rough << ' ' << seed;
      EXPECT_LT(steep, radians(25.0)) << rough << ' ' << seed;
    }
}

TEST(Terrain, RoughLandIsRough) {
  double rolling = 0, broken = 0;  // how much neighbouring slopes differ
  for (std::uint64_t seed = 0; seed < 5; ++seed)
    for (double rough : {0.0, 1.0}) {
      TerrainShape shape;
      shape.rough = rough;
      Terrain land(shape, Seed{seed});
      for (int i = 0; i < 1000; ++i) {
        Vec2 at = somewhere(i, 75);
        (rough > 0 ? broken : rolling) += glm::distance(slope_at(land, at), slope_at(land, at + 2.0f));
      }
    }
  EXPECT_GT(broken, 2 * rolling);
}

TEST(Terrain, ThePathIsLevelAcrossAndGentleAlong) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    TerrainShape shape = shape_of(0.5);
    shape.hills = 14;
    Terrain land(shape, Seed{seed});
    const std::vector<Vec2>& path = land.plot().path();
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      if (std::max(std::abs(path[i].x), std::abs(path[i].y)) > 78) continue;
      Vec2 along = glm::normalize(path[i + 1] - path[i - 1]), across(-along.y, along.x);
      EXPECT_LT(land.path_distance(path[i]), -0.7);
      double middle = land.height(path[i].x, path[i].y);
      for (float side : {-0.95f, -0.5f, 0.5f, 0.95f}) {
        Vec2 at = path[i] + across * side;
        EXPECT_NEAR(land.height(at.x, at.y), middle, 0.05) << seed << ' ' << i << ' ' << side;
      }
      Vec2 on = path[i] + along;
      EXPECT_LT(std::abs(land.height(on.x, on.y) - middle), 0.6);
    }
  }
}

TEST(Terrain, TakesOddShapes) {
  for (TerrainShape shape : {TerrainShape{2, 0, 70, 0.4, 0, {}}, TerrainShape{2, 500, 1, 1, 1, {}},
                             TerrainShape{4000, 500, 5000, 0, 1, {{Vec2(-3000, 0), Vec2(3000, 10)}, 20}},
                             TerrainShape{50, 5, 20, 0.5, 0.3, {{Vec2(3, 3), Vec2(3, 3)}, 1}}}) {
    Terrain land(shape, Seed{4});
    EXPECT_EQ(land.surface().find_fault(), "");
    EXPECT_GE(land.reach(), std::max(1199.0, shape.size));
    for (int i = 0; i < 500; ++i) {
      Vec2 at = somewhere(i, land.reach());
      EXPECT_TRUE(std::isfinite(land.height(at.x, at.y)));
    }
  }
}

TEST(Terrain, IsTheSameForTheSameSeed) {
  Terrain one(shape_of(0.4), Seed{5}), two(shape_of(0.4), Seed{5}), other(shape_of(0.4), Seed{6});
  EXPECT_EQ(one.surface().position, two.surface().position);
  EXPECT_NE(one.surface().position, other.surface().position);
}

}  // namespace
}  // namespace frond
