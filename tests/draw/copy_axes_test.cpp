#include "draw/copy_axes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace frond {
namespace {

TEST(CopyAxes, SownHerbsLeanInTheWind) {
  Result<Preset> preset = read_preset(R"({"film": {"frames": 48, "fps": 24},
      "scene": {"setting": "meadow", "wind": {"speed": 12, "direction": [0, 0, 2]}}, "organisms": [
      {"kind": "plant", "grammar": {"axiom": "FFF"}, "count": 3, "sown": {}, "place": {"lean": 0}}, {"kind": "vase", "count": 3, "sown": {}}]})",
                                      "test.json", {});
  ASSERT_TRUE(preset) << preset.errors().front().text();
  Result<Scene> built = build_scene(*preset);
  ASSERT_TRUE(built) << built.errors().front().text();
  const Scene& scene = *built;
  ASSERT_EQ(scene.copy_sets.size(), 2u);
  EXPECT_FALSE(scene.copy_sets[1].wind);
  ASSERT_TRUE(scene.copy_sets[0].wind);
  double least = 1e9, most = -1e9;
  for (int frame = 0; frame < 48; ++frame) {
    Vec3 up = copy_axes(scene.copy_sets[0], scene.film, 0, frame / 24.0) * Vec3(0, 1, 0);
    EXPECT_LT(glm::length(Vec2(up.x, up.z)), 1.2f * up.y);
    least = std::min<double>(least, up.z), most = std::max<double>(most, up.z);
  }
  EXPECT_GT(least + most, 0.05) << "leans with the wind, toward z";
  EXPECT_GT(most - least, 0.01) << "and swings";
}

}  // namespace
}  // namespace frond
