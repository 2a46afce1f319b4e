#include "film/soft_light.h"

#include <gtest/gtest.h>

#include "draw/eyes.h"

namespace frond {
namespace {

/// Whether the soft light of a coral that moves so is another in each frame.
bool changes(const std::string& motion) {
  Scene scene = *build_scene(*read_preset(
      R"({"film": {"frames": 24}, "scene": {"camera": {"location": [0, 0.6, 3], "look_at": [0, 0.4, 0]}},
          "organisms": [{"kind": "coral", "steps": 3, "height": 0.6, "place": {"at": [[0, 0]]}, )" +
          motion + "}]}",
      "light.json", {}));
  return light_changes(scene, nearest_pixels(scene));
}

TEST(SoftLight, IsThatOfEachFrameWhereBranchesWouldLeaveIt) {
  EXPECT_FALSE(changes(R"("wave": {"amplitude": 2})"));
  EXPECT_TRUE(changes(R"("wave": {"amplitude": 40})"));
  EXPECT_FALSE(changes(R"("food": {"strength": 60, "position": [1, 0.5, 0]})")) << "the food stays";
  std::string moving = R"("position": [[0, [1, 0.5, 0]], [1, [-1, 0.5, 0]]]})";
  EXPECT_TRUE(changes(R"("food": {"strength": 60, )" + moving));
  EXPECT_TRUE(changes(R"("food": {"stretch": 2, )" + moving));
}

}  // namespace
}  // namespace frond
