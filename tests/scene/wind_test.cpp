#include "scene/wind.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

Scene windy(const std::string& organisms, const std::string& more = "") {
  Result<Preset> preset = read_preset(
      R"({"film": {"frames": 48, "fps": 24}, "scene": {"setting": "meadow", "wind": {"speed": 12, "direction": [0, 0, 2]}},
          "organisms": [)" +
          organisms + "]" + more + "}",
      "test.json", {});
  if (!preset) ADD_FAILURE() << preset.errors().front().text();
  Result<Scene> built = build_scene(*preset);
  if (!built) ADD_FAILURE() << built.errors().front().text();
  return *built;
}

TEST(SceneWind, TreesWithoutAWaveFollowIt) {
  Scene scene = windy(R"({"kind": "tree", "years": 5, "place": {"at": [[0, 0]]}},
      {"kind": "tree", "years": 5, "place": {"at": [[4, 0]]}, "wave": {"amplitude": 4}},
      {"kind": "weber_penn", "place": {"at": [[0, 8]]}})");
  ASSERT_EQ(scene.specimens.size(), 3u);
  EXPECT_TRUE(scene.specimens[0].motion.sway);
  EXPECT_FALSE(scene.specimens[1].motion.sway);
  EXPECT_TRUE(scene.specimens[2].motion.sway);
  EXPECT_EQ(scene.specimens[0].motion.sway->wind, scene.specimens[2].motion.sway->wind) << "one wind";
}

TEST(SceneWind, AFilmOfAGrowingTreeInAStormDoesNotJump) {
  Scene scene = windy(
      R"({"kind": "tree", "years": 8, "anchorage": 40, "weather": {"wind": 6}, "place": {"at": [[0, 0]]},
      "growth": {"start": -14, "duration": 17}})",
      R"(, "events": [{"year": 7, "storm": 1}])");
  const Specimen& tree = scene.specimens.at(0);
  ASSERT_FALSE(tree.motion.sway->wind->gales.empty());
  ASSERT_TRUE(tree.life.fall) << "the storm throws it";
  Vec3 moved = tree.life.fall->axis;
  EXPECT_GT(moved.x, 0.9f) << "along the wind, z";
  float all = 0, most = 0;
  Vec3 last(0);
  for (int frame = 0; frame < 48; ++frame) {
    Pose pose;
    auto now = developed(tree, frame / 24.0);
    ASSERT_TRUE(now);
    pose_specimen(**now, frame / 24.0, pose);
    Vec3 top = pose.position[0];
    for (const Vec3& at : pose.position)
      if (glm::distance(at, pose.position[0]) > glm::distance(top, pose.position[0])) top = at;
    if (frame > 0) all += glm::distance(top, last), most = std::max(most, glm::distance(top, last));
    last = top;
  }
  EXPECT_LT(most, std::max(8 * all / 47, 0.2f));
}

TEST(SceneWind, FelledTreesLeaveAStump) {
  Scene scene =
      windy(R"({"kind": "tree", "name": "oak", "count": 2, "years": 8, "place": {"at": [[0, 0], [6, 0]]}})",
            R"(, "events": [{"year": 6, "cut": {"share": 0.5}}])");
  int felled = 0;
  for (const Specimen& tree : scene.specimens) {
    if (!tree.life.fall) continue;
    ++felled;
    Pose pose;
    pose_specimen(tree, 0, pose);
    float highest = 0, ground = 1e9f;
    for (std::size_t i = 0; i < pose.position.size(); ++i) {
      highest = std::max(highest, pose.position[i].y);
      if (tree.model.skeleton.parent[i] != Skeleton::kRoot) continue;
      ground = std::min(ground, glm::distance(pose.position[i], tree.model.skeleton.position[i]));
    }
    EXPECT_LT(highest, 2.5f) << "it lies";
    EXPECT_EQ(ground, 0) << "its stump stays";
  }
  EXPECT_EQ(felled, 1);
}

}  // namespace
}  // namespace frond
