#include "land/ground.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace frond {
namespace {

TEST(Ground, MeshLiesOnTheHeights) {
  Ground ground{Seed{2}, 0.2, 2.5};
  Surface s = ground_surface(ground, Vec2(0), {20, 40});
  EXPECT_EQ(s.find_fault(), "");
  for (const Vec3& p : s.position) {
    if (std::hypot(p.x, p.z) < 10) {
      EXPECT_NEAR(p.y, ground_height(ground, p.x, p.z), 1e-4);
    }
    EXPECT_LE(std::abs(p.y), 0.5);
  }
  for (const Vec3& n : s.normal) EXPECT_GT(n.y, 0.5f);
}

TEST(Ground, MeshesHardlyGrowWithTheDistanceThatTheyReach) {
  auto rings = [](double reach) {
    GroundDisc disc = GroundDisc{150, 110}.reaching(reach, 600);
    return ground_surface(Ground{Seed{1}, 0.1, 3}, Vec2(0), disc).triangle.size();
  };
  std::size_t least = rings(150), even = rings(600);
  EXPECT_NEAR(static_cast<double>(even) / static_cast<double>(least), 4, 0.1) << "what is near stays as fine";
  EXPECT_LT(rings(5000), 2.2 * static_cast<double>(even));
  EXPECT_LT(rings(1e6), 5 * even);
}

TEST(Ground, MeshesReachAsFarAsTheyAreToAndAreWhole) {
  GroundDisc disc = GroundDisc{32, 20}.reaching(3000, 128);
  Surface s = ground_surface([](Vec2) { return 1.0; }, Vec2(0), disc);
  EXPECT_EQ(s.find_fault(), "");
  double area = 0, far = 0;
  for (auto [a, b, c] : s.triangle)
    area += 0.5 * static_cast<double>(
                      glm::length(glm::cross(s.position[b] - s.position[a], s.position[c] - s.position[a])));
  for (const Vec3& p : s.position) far = std::max<double>(far, std::hypot(p.x, p.z));
  EXPECT_NEAR(far, 3000, 0.1);
  EXPECT_NEAR(area / (kPi * 3000 * 3000), 1, 0.01);
}

TEST(Heights, AreThoseOfTheMeshAtAnyDistance) {
  auto hills = [](Vec2 at) { return std::sin(0.01 * at.x) + 0.001 * at.y; };
  Surface mesh = ground_surface(hills, Vec2(0), GroundDisc{150, 60}.reaching(20'000, 600));
  Heights heights(mesh);
  Seed seed{3};
  for (std::uint64_t i = 0; i < 300; ++i) {  // middles of triangles, all over
    auto [a, b, c] = mesh.triangle[seed.child(i).bits() % mesh.triangle.size()];
    Vec3 middle = (mesh.position[a] + mesh.position[b] + mesh.position[c]) / 3.0f;
    EXPECT_NEAR(heights(middle.x, middle.z), middle.y, 1e-3 + 1e-6 * glm::length(middle));
  }
  EXPECT_EQ(heights(30'000, 0), 0) << "beyond the mesh";
}

TEST(Heights, AreFoundAsFastFarOffAsNear) {
  Surface mesh = ground_surface([](Vec2) { return 2.0; }, Vec2(0), GroundDisc{150, 110}.reaching(5000, 600));
  Heights heights(mesh);
  std::clock_t begin = std::clock();
  double sum = 0;
  constexpr int kAsked = 200'000;
  for (int i = 0; i < kAsked; ++i) sum += heights(4000 + 0.001 * i, 300);
  EXPECT_DOUBLE_EQ(sum, 2.0 * kAsked);
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 2.0) << "not by all triangles";
}

}  // namespace
}  // namespace frond
