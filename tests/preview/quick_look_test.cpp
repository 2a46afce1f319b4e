#include "preview/quick_look.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "draw/sizes.h"
#include "scene/camera.h"
#include "scene_at.h"

namespace frond {
namespace {

/// A column of 2 m on a lawn in the sun.
Scene column(const std::string& camera) {
  return *build_scene(*read_preset(R"({"film": {"frames": 1, "size": [120, 90]},
      "scene": {"setting": "meadow", "meadow": {"sun": [1, 1, 0]}, "camera": {)" +
                                       camera + R"(}},
      "organisms": [{"kind": "column", "name": "column", "height": 2, "place": {"at": [[0, 0]]}}]})",
                                   "test.json", {}));
}

int brightness(const Raster& r, int x, int y) { return r.at(x, y, 0) + r.at(x, y, 1) + r.at(x, y, 2); }

TEST(QuickLook, ShowsThingsWhereTheCameraSeesThemAndTheirShadows) {
  Scene scene = column(R"("location": [0, 1.5, 8], "look_at": [0, 1, 0])");
  Raster with = quick_look(scene, 0);
  Raster bare = quick_look(column(R"("location": [0, 1.5, 8], "look_at": [0, 1, 0], "angle": 45)"), 0);
  EXPECT_EQ(with.data, bare.data) << "the same twice";
  scene.specimens.clear();
  Raster without = quick_look(scene, 0);
  Lens lens = lens_at(scene.setup.camera, 0, 0.75);
  auto pixel = [&](Vec3 p) {
    Vec3 at = lens.seen(p);
    return std::pair{static_cast<int>((1 + at.x) * 60), static_cast<int>((1 - at.y) * 45)};
  };
  auto differs = [&](Vec3 p) {
    p.y += scene.ground->height({p.x, p.z});
    auto [x, y] = pixel(p);
    return brightness(with, x, y) - brightness(without, x, y);
  };
  EXPECT_NE(differs({0, 1, 0.2f}), 0) << "the column";
  EXPECT_LT(differs({-0.9f, 0, 0}), -30) << "its shadow falls away from the sun";
  EXPECT_EQ(differs({0.9f, 0, 0}), 0) << "and not toward it";
  EXPECT_EQ(differs({0, 3, 0}), 0) << "nothing is above it";
}

TEST(QuickLook, SizesAreThoseOfWhatGrew) {
  Result<Preset> preset = read_preset(R"({"organisms": [
      {"kind": "column", "name": "column", "height": 2, "count": 2, "place": {"at": [[0, 0], [3, 0]], "size_variation": 0, "lean": 0}},
      {"kind": "plant", "name": "pole", "height": 4, "place": {"at": [[-2, 0]], "size_variation": 0, "lean": 0},
       "grammar": {"axiom": "FFFF"}, "thickness": {"from": "pipe", "radius": 0.1, "least": 0.1, "flare": 0}}]})",
                                      "test.json", {});
  ASSERT_TRUE(preset) << preset.errors()[0].text();
  std::vector<GrownSize> sizes = *sizes_of(*build_scene(*preset), *preset, 0);
  ASSERT_EQ(sizes.size(), 2u);
  EXPECT_EQ(sizes[0].count, 2u);
  EXPECT_NEAR(sizes[0].height, 2, 0.1);
  EXPECT_EQ(sizes[0].stem, 0);
  EXPECT_NEAR(sizes[1].height, 4, 0.25);
  EXPECT_NEAR(sizes[1].stem, 0.2, 0.02);
  EXPECT_EQ(sizes_lines(sizes)[1].substr(0, 7), "pole: 4");
}

TEST(QuickLook, FlatWallsHaveNoDarkDots) {
  // Light that comes along a wall at all hours.
  for (const char* hour : {"9", "12", "14", "15.5", "17"}) {
    SCOPED_TRACE(hour);
    Result<Preset> preset = read_preset(
        R"({"film": {"frames": 1, "size": [320, 200]}, "scene": {"setting": "garden", "garden": {"hour": )" +
            std::string(hour) +
            R"(}, "camera": {"location": [-4, 2, 10], "look_at": [0, 1.6, 0], "angle": 42}},
            "organisms": [{"kind": "mesh", "file": "summerhouse_plain.obj", "size": 4, "color": "#e0d8c8",
              "place": {"at": [[0, 0]], "turn_variation": 0, "lean": 0, "size_variation": 0}}]})",
        "tests/cases/16-rhino-obj/test.json", {});
    ASSERT_TRUE(preset) << preset.errors()[0].text();
    Raster look = quick_look(*build_scene(*preset), 0);
    int dots = 0;
    for (int y = 1; y + 1 < look.height; ++y)
      for (int x = 1; x + 1 < look.width; ++x) {
        int around = std::min({brightness(look, x - 1, y), brightness(look, x + 1, y),
                               brightness(look, x, y - 1), brightness(look, x, y + 1)});
        dots += brightness(look, x, y) < around - 90;
      }
    EXPECT_LT(dots, 3);
  }
}

TEST(QuickLook, SizesAreThoseOfTheTimeNotOfTheEnd) {
  Result<Preset> preset = read_preset(R"({"film": {"frames": 21, "fps": 10}, "organisms": [
      {"kind": "plant", "name": "pole", "place": {"at": [[0, 0]], "size_variation": 0, "lean": 0}, "height": 4,
       "grammar": {"axiom": "FFFFFFFF"}, "growth": {"start": 0.5, "duration": 1.5}}]})",
                                      "test.json", {});
  ASSERT_TRUE(preset) << preset.errors()[0].text();
  Scene scene = *build_scene(*preset);
  auto height = [&](double time) { return (*sizes_of(scene, *preset, time))[0].height; };
  EXPECT_LT(height(1), 3);
  EXPECT_GT(height(1.5), height(1) + 0.3);
  EXPECT_NEAR(height(2), 4, 0.3);
  std::vector<GrownSize> before = *sizes_of(scene, *preset, 0);
  EXPECT_EQ(sizes_lines(before)[0], "pole: nothing of it is to be seen yet");
}

}  // namespace
}  // namespace frond
