#include "scene/forest_floor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frond {
namespace {

ForestLand level_land() {
  return {[](Vec2) { return 2.0; }, [](Vec2) { return 1e6; }};
}

Scene forest_scene() {
  Scene scene;
  scene.stage.setting = Setting::forest;
  scene.film.frames = 1;
  return scene;
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

TEST(ForestFloor, tells_its_texture_where_the_path_is) {
  Scene scene = forest_scene();
  scene.floor.position = {Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(0, 0, 90)};
  ForestLand land{[](Vec2) { return 0.0; }, [](Vec2 at) { return glm::length(at) - 1.0; }};
  mark_floor(scene, land, Seed{1});
  ASSERT_EQ(scene.floor.uv.size(), 3u);
  EXPECT_FLOAT_EQ(scene.floor.uv[0].x, -1);
  EXPECT_FLOAT_EQ(scene.floor.uv[1].x, 2);
  EXPECT_FLOAT_EQ(scene.floor.uv[2].x, 8);
}

TEST(ForestFloor, is_strewn_near_the_camera_over_the_whole_film) {
  Scene scene = forest_scene();
  scene.film.frames = 48;
  scene.stage.camera.location = Animated<Vec3>({{0.0, Vec3(0, 2, 0)}, {2.0, Vec3(40, 2, 0)}});
  strew_floor(scene, {[](Vec2 at) { return 0.1 * at.x; }, [](Vec2) { return 1e6; }}, Seed{1});
  int start = 0, middle = 0, end = 0;
  for (const TurfInstance& patch : scene.litter_instances) {
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

TEST(ForestFloor, has_few_leaves_on_the_path) {
  Scene scene = forest_scene();
  strew_floor(scene, {[](Vec2) { return 0.0; }, [](Vec2 at) { return std::abs(at.x) - 1.0; }}, Seed{1});
  auto triangles = [&](bool path) {
    std::size_t sum = 0;
    for (const TurfInstance& patch : scene.litter_instances)
      if (path ? std::abs(patch.at.x) < 0.7 : std::abs(patch.at.x) > 1.3 && std::abs(patch.at.x) < 2)
        sum += scene.litter[static_cast<std::size_t>(patch.shape)].triangle.size();
    return sum;
  };
  EXPECT_LT(3 * triangles(true), triangles(false));
  for (const TurfInstance& cushion : scene.moss_instances) EXPECT_GT(std::abs(cushion.at.x), 0.9);
}

}  // namespace
}  // namespace frond
