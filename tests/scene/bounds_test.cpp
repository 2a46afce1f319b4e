#include "scene/bounds.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scene/scene.h"

namespace frond {
namespace {

/// The first thing that is wrong with a preset; empty where nothing is.
std::string fault(const std::string& text) {
  Result<Preset> preset = read_preset(text, "x", {});
  return preset ? "" : preset.errors().front().text();
}

TEST(Bounds, NumbersThatBecomeTooManyAreRefusedWhereTheyStand) {
  const std::pair<const char*, const char*> cases[] = {
      {R"({"scene": {"setting": "meadow", "meadow": {"blade": 0.0001}}, "organisms": []})",
       "/scene/meadow/blade: grass of 0.0001 m takes 1e+09 patches as far as 9 m; expected 400000 at most"},
      {R"({"scene": {"setting": "garden", "meadow": {"blade": 1e-12}}, "organisms": []})",
       "/scene/meadow/blade:"},
      {R"({"scene": {"setting": "meadow", "meadow": {"blade": 5, "blades": 20000}}, "organisms": []})",
       "/scene/meadow/blades:"},
      {R"({"scene": {"setting": "garden", "garden": {"path": {"points": [[0, 0], [1e30, 0]]}}}, "organisms": []})",
       "/scene/garden/path/points/1: lies off the ground"},
      {R"({"scene": {"setting": "forest", "forest": {"terrain": {"path": {"points": [[0, 0], [1e9, 0]]}}}},
          "organisms": []})",
       "/scene/forest/terrain/path/points/1: lies off the ground"},
      {R"({"scene": {"setting": "garden", "garden": {"gravel": 0.02, "path": {"width": 20, "points":
          [[-140, 0], [140, 0], [-140, 9], [140, 9], [-140, 18], [140, 18]]}}}, "organisms": []})",
       "/scene/garden/gravel: stones of 0.02 m"},
      {R"({"film": {"frames": 1000, "fps": 1}, "scene": {"setting": "forest", "camera": {"location":
          [[0, [-1000, 2, 0]], [200, [1000, 2, 0]], [400, [-1000, 2, 0]], [600, [1000, 2, 0]],
           [800, [-1000, 2, 0]], [900, [1000, 2, 0]], [950, [-1000, 2, 0]]]}}, "organisms": []})",
       "/scene/camera/location: the camera goes"},
      {R"({"scene": {"setting": "meadow"}, "organisms": [{"kind": "pebbles", "shapes": 1000, "depth": 8}]})",
       "/organisms/0/shapes: so many shapes"},
      {R"({"scene": {"setting": "meadow"}, "organisms": [{"kind": "tree", "coat": {"pixels": 8192, "aspect": 16}}]})",
       "/organisms/0/coat/pixels: makes a picture of 8192 x 131072 pixels"},
      {R"({"scene": {"setting": "meadow"}, "organisms": [{"kind": "colonized", "leaves":
          {"shape": "own", "pixels": 4096, "width": 4, "outline": [1, 1, 1, 100, 1, 1, 1]}}]})",
       "/organisms/0/leaves/pixels: makes a picture"},
      {R"({"scene": {"setting": "forest", "forest": {"terrain": {"size": 4000}}}, "organisms":
          [{"kind": "tree", "count": 2, "light": {"voxel": 0.05}, "place": {"at": [[-1900, 0], [1900, 0]]}}]})",
       "/organisms/0/light/voxel: cells of 0.05 m are too many"},
      {R"({"scene": {"setting": "meadow"}, "organisms": [{"kind": "colonized", "envelope":
          {"shape": "outline", "path": "M0 0 L1e30 0 L0 1Z"}}]})",
       "a number from -1e9 to 1e9"},
      {R"({"scene": {"setting": "meadow"}, "organisms": [{"kind": "colonized", "envelope":
          {"shape": "outline", "path": "M0 0 L1e9 0 L0 1Z"}}]})",
       "the silhouette is 1e+09 times as wide as high; expected 100 times at most"}};
  for (auto [text, expected] : cases)
    EXPECT_NE(fault(text).find(expected), std::string::npos) << text << fault(text);
}

TEST(Bounds, MoreThanCouldStandIsRefusedBeforeItIsScattered) {
  EXPECT_NE(
      fault(R"({"organisms": [{"kind": "coral", "count": 1000000, "place": {"radius": 23}}]})")
          .find(
              "1:43: /organisms/0/count: 1000000 have no room: each keeps 0.35 m free round itself, so that "
              "2710 at most could stand there"),
      std::string::npos);
  EXPECT_NE(
      fault(
          R"({"scene": {"setting": "meadow"}, "organisms": [{"kind": "rock", "count": 1000000, "sown": {}}]})")
          .find("/organisms/0/count: 1000000 have no room"),
      std::string::npos);
  // What stands at given places needs no ring.
  EXPECT_EQ(
      fault(
          R"({"organisms": [{"kind": "coral", "count": 2, "place": {"radius": 0, "at": [[0, 0], [1, 0]]}}]})"),
      "");
}

TEST(Bounds, TheGroundReachesAsFarAsWhatStandsOnIt) {
  const std::string far = R"("organisms": [{"kind": "rock", "depth": 3, "place":
      {"center": [28, 28], "radius": 28, "inner": 27}}])";
  for (const char* setting : {"underwater", "meadow", "garden"}) {
    Result<Preset> preset = read_preset(
        R"({"film": {"frames": 1}, "scene": {"setting": ")" + std::string(setting) + R"("}, )" + far + "}",
        "x", {});
    ASSERT_TRUE(preset.ok());
    float edge = 0;
    Scene scene = *build_scene(*preset);
    for (const Vec3& p : scene.ground->floor().position) edge = std::max(edge, glm::length(Vec2(p.x, p.z)));
    EXPECT_GT(edge, reach_of(*preset)) << setting;
  }
}

}  // namespace
}  // namespace frond
