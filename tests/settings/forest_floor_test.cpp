#include "settings/forest_floor.h"

#include <gtest/gtest.h>

#include <ctime>

#include <algorithm>
#include <cmath>

namespace frond {
namespace {

ForestLand level_land() {
  return {[](Vec2) { return 2.0; }, [](Vec2) { return 1e6; }};
}

double green_share(const ForestLand& land, double moss) {
  int green = 0, all = 0;
  for (int x = 0; x < 90; ++x)
    for (int z = 0; z < 90; ++z, ++all)
      green += mossiness(land, moss, Vec2(0.73f * static_cast<float>(x), 0.73f * static_cast<float>(z)),
                         Seed{3}) > 0.5;
  return static_cast<double>(green) / all;
}

TEST(ForestFloor, is_as_green_as_asked_on_level_land) {
  for (double moss : {0.1, 0.25, 0.4, 0.6, 0.8}) EXPECT_NEAR(green_share(level_land(), moss), moss, 0.08);
  EXPECT_EQ(green_share(level_land(), 0), 0);
  EXPECT_GT(green_share(level_land(), 1), 0.99);
}

TEST(ForestFloor, is_less_green_on_slopes_and_not_on_the_path) {
  ForestLand steep{[](Vec2 at) { return 0.8 * at.x; }, [](Vec2) { return 1e6; }};
  EXPECT_LT(green_share(steep, 0.5), 0.3);
  ForestLand trodden{[](Vec2) { return 0.0; }, [](Vec2) { return -0.5; }};
  EXPECT_LT(green_share(trodden, 0.5), 0.02);
}

TEST(ForestFloor, is_green_as_far_as_a_map_lets_it) {
  ForestLand land = level_land();
  auto mossy = [&](Vec2 at) { return mossiness(land, 0.6, at, Seed{3}); };
  std::vector<double> before;
  for (int i = 0; i < 200; ++i) before.push_back(mossy(Vec2(0.37f * static_cast<float>(i), 1)));
  for (double share : {1.0, 0.5, 0.0}) {
    land.moss = [share](Vec2) { return share; };
    for (int i = 0; i < 200; ++i) {
      double now = mossy(Vec2(0.37f * static_cast<float>(i), 1)), was = before[static_cast<std::size_t>(i)];
      EXPECT_LE(now, was);
      EXPECT_TRUE(share < 1 || now == was);
      EXPECT_TRUE(share > 0 || now == 0);
    }
  }
}

TEST(ForestFloor, tells_its_texture_where_the_path_is) {
  Surface floor;
  floor.position = {Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(0, 0, 90)};
  ForestLand land{[](Vec2) { return 0.0; }, [](Vec2 at) { return glm::length(at) - 1.0; }};
  mark_floor(floor, land, 0.4, Seed{1});
  ASSERT_EQ(floor.uv.size(), 3u);
  EXPECT_FLOAT_EQ(floor.uv[0].x, -1);
  EXPECT_FLOAT_EQ(floor.uv[1].x, 2);
  EXPECT_FLOAT_EQ(floor.uv[2].x, 8);
}

TEST(ForestFloor, is_strewn_near_the_camera_over_the_whole_film) {
  Film film;
  film.frames = 48;
  Camera camera;
  camera.location = Animated<Vec3>({{0.0, Vec3(0, 2, 0)}, {2.0, Vec3(40, 2, 0)}});
  ForestCover cover =
      strew_floor(film, camera, {[](Vec2 at) { return 0.1 * at.x; }, [](Vec2) { return 1e6; }}, 0.4, Seed{1});
  int start = 0, middle = 0, end = 0;
  for (const Patch& patch : cover.litter_patches) {
    double away = std::max({-patch.at.x, patch.at.x - 40.0f, 0.0f});
    EXPECT_LT(std::hypot(away, patch.at.z), 14.1);
    EXPECT_NEAR(patch.at.y, 0.1 * patch.at.x, 1e-4);
    EXPECT_NEAR(patch.slope.x, 0.1, 1e-4);
    for (auto [count, x] : {std::pair{&start, 0.0f}, {&middle, 20.0f}, {&end, 40.0f}})
      *count += std::hypot(patch.at.x - x, patch.at.z) < 3;
  }
  double whole = kPi * 9 / 0.16;  // patches
  for (int count : {start, middle, end}) EXPECT_NEAR(count, whole, 0.2 * whole);
}

TEST(ForestFloor, TakesNoLongerForAWayAllRoundThanForAStraightOne) {
  Film film;
  film.frames = 2000;
  Camera camera;  // round a square of a kilometre, half a second a side
  double side = film.length() / 4;
  camera.location = Animated<Vec3>({{0.0, Vec3(0, 2, 0)},
                                    {side, Vec3(1000, 2, 0)},
                                    {2 * side, Vec3(1000, 2, 1000)},
                                    {3 * side, Vec3(0, 2, 1000)},
                                    {4 * side, Vec3(0, 2, 0)}});
  std::clock_t begin = std::clock();
  ForestCover cover =
      strew_floor(film, camera, {[](Vec2) { return 0.0; }, [](Vec2) { return 1e6; }}, 0, Seed{1});
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 15.0) << "not all that lies within";
  EXPECT_GT(cover.litter_patches.size(), 200'000u);
  for (const Patch& patch : cover.litter_patches) {
    float inside = std::min({patch.at.x, patch.at.z, 1000 - patch.at.x, 1000 - patch.at.z});
    ASSERT_LT(std::abs(inside), 200.0f);
  }
}

TEST(ForestFloor, has_few_leaves_on_the_path) {
  Film film;
  film.frames = 1;
  ForestCover cover = strew_floor(
      film, {}, {[](Vec2) { return 0.0; }, [](Vec2 at) { return std::abs(at.x) - 1.0; }}, 0.4, Seed{1});
  auto triangles = [&](bool path) {
    std::size_t sum = 0;
    for (const Patch& patch : cover.litter_patches)
      if (path ? std::abs(patch.at.x) < 0.7 : std::abs(patch.at.x) > 1.3 && std::abs(patch.at.x) < 2)
        sum += cover.litter[static_cast<std::size_t>(patch.shape)].triangle.size();
    return sum;
  };
  EXPECT_LT(3 * triangles(true), triangles(false));
  for (const Patch& cushion : cover.moss_patches) EXPECT_GT(std::abs(cushion.at.x), 0.9);
}

TEST(ForestFloor, TheMiddleOfAMountainsPathLiesBetweenItsSides) {
  Surface floor;
  for (float z : {-30.0f, -6.0f, 6.0f, 30.0f})
    for (float x : {-90.0f, 0.0f, 90.0f}) floor.position.emplace_back(x, 0, z);
  ForestLand land{[](Vec2) { return 50.0; }, [](Vec2) { return 1e6; }};
  mark_mountain(floor, land, {.trees = 500}, {{-40, 0}, {0, 0}, {40, 0}}, 4);
  // Also behind its ends, and the farther off the larger.
  for (std::size_t i = 0; i < floor.uv.size(); ++i) {
    float z = floor.position[i].z;
    EXPECT_FLOAT_EQ(std::abs(floor.uv[i].x), std::abs(z) > 20 ? 9 : 3) << i;
    EXPECT_EQ(floor.uv[i].x > 0, (floor.uv[0].x > 0) == (z < 0)) << i;
    EXPECT_EQ(floor.uv[i].y, 0) << "below the tree line";
  }
}

}  // namespace
}  // namespace frond
