#include <gtest/gtest.h>

#include "scene/scene.h"

namespace frond {
namespace {

const std::string kTree = R"({"kind": "tree", "years": 16, "habit": {"clear_trunk": 0},
  "place": {"at": [[0, 0]], "size_variation": 0, "lean": 0}})";

/// A wall 12 m high whose face is a metre from the tree, turned about the vertical through the tree's foot.
std::string wall(const std::string& at, int turn) {
  return R"({"kind": "wall", "width": 16, "height": 12, "place": {"at": [)" + at + R"(], "turn": )" +
         std::to_string(turn) + R"(, "turn_variation": 0, "lean": 0, "size_variation": 0}})";
}

Scene scene_of(const std::string& organisms) {
  Result<Preset> preset = read_preset(
      R"({"seed": 5, "scene": {"setting": "studio"}, "organisms": [)" + organisms + "]}", "test.json", {});
  EXPECT_TRUE(preset.ok()) << preset.errors()[0].text();
  return *build_scene(*preset);
}

struct Crown {
  double middle = 0;  // metres along the way from the wall
  std::size_t near = 0, far = 0;
};

Crown crown_of(const Specimen& tree, Vec3 away) {
  Crown crown;
  for (Vec3 leaf : tree.model.organs.position) {
    float x = glm::dot(leaf, away);
    crown.middle += x / static_cast<double>(tree.model.organs.size());
    ++(x < 0 ? crown.near : crown.far);
  }
  return crown;
}

TEST(SceneBodies, ATreeLeansAwayFromAWall) {
  Scene open = scene_of(kTree);
  struct {
    std::string at;
    int turn;
    Vec3 away;
  } sides[] = {{"[0, -1.1]", 0, Vec3(0, 0, 1)}, {"[-1.1, 0]", 90, Vec3(1, 0, 0)}};
  for (const auto& side : sides) {
    Scene shaded = scene_of(kTree + "," + wall(side.at, side.turn));
    const Specimen& tree = shaded.specimens[0];
    ASSERT_GT(tree.model.organs.size(), 100u);
    Crown lone = crown_of(open.specimens[0], side.away), crown = crown_of(tree, side.away);
    EXPECT_GT(crown.middle, lone.middle + 0.3) << side.turn;
    EXPECT_LT(2 * crown.near, crown.far) << side.turn;
    EXPECT_LT(2 * crown.near, lone.near) << side.turn;
  }
}

TEST(SceneBodies, FarAwayChangeNothing) {
  Scene open = scene_of(kTree), far = scene_of(kTree + "," + wall("[0, -28]", 0));
  EXPECT_EQ(open.specimens[0].model.skeleton.position, far.specimens[0].model.skeleton.position);
}

}  // namespace
}  // namespace frond
