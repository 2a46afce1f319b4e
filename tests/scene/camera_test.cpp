#include "scene/camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/scene.h"

namespace frond {
namespace {

TEST(Camera, FollowsTheGround) {
  auto scene_of = [](const std::string& camera) {
    return *build_scene(*read_preset(R"({"film": {"frames": 96, "fps": 24}, "scene": {"setting": "forest",
        "forest": {"terrain": {"hills": 16}}, "camera": {"look_at": [0, 1, 0], )" +
                                         camera + "}}}",
                                     "test.json", {}));
  };
  const std::string walk = R"("location": [[0, [-60, 1.7, 20]], [2, [0, 1.7, 35]], [4, [50, 3, -10]]])";
  Scene still = scene_of(walk), follows = scene_of(walk + R"(, "follow": true)");
  const Heights& heights = follows.ground->heights();
  double least = 1e9, most = -1e9;
  for (double t = 0; t <= 4; t += 0.05) {
    Vec3 given = still.stage.camera.location.at(t), at = follows.stage.camera.location.at(t);
    EXPECT_NEAR(at.x, given.x, 0.1);
    EXPECT_NEAR(at.z, given.z, 0.1);
    double ground = heights(at.x, at.z);
    EXPECT_NEAR(at.y - ground, given.y, 0.5) << t;
    least = std::min(least, ground), most = std::max(most, ground);
  }
  EXPECT_GT(most - least, 3) << "hill and dale";
  EXPECT_TRUE(follows.stage.camera.look_at.constant());
  EXPECT_NEAR(follows.stage.camera.look_at.at(0).y, 1, 0.2);
  EXPECT_EQ(still.stage.camera.location.at(1).y, 1.7f);
}

}  // namespace
}  // namespace frond
