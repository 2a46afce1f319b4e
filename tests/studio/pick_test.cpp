#include "studio/pick.h"

#include <gtest/gtest.h>

#include "pruning/address.h"

namespace frond {
namespace {

Scene scene_of(const std::string& organisms) {
  Result<Preset> preset = read_preset(
      R"({"film": {"frames": 1}, "scene": {"setting": "studio"}, "organisms": [)" + organisms + "]}",
      "pick.json", {});
  if (!preset) ADD_FAILURE() << preset.errors().front().text();
  return std::move(*build_scene(*preset));
}

const char* kCorals =
    R"({"kind": "coral", "name": "a", "steps": 3, "place": {"at": [[0, 0], [2, 0]], "rock": 0}, "count": 2})";

TEST(Pick, ARayMeetsTheBranchThatItIsSentThrough) {
  Scene scene = scene_of(kCorals);
  PosedScene posed_scene = *posed(scene, 0);
  int met = 0;
  for (const PosedScene::One& one : posed_scene.specimens) {
    const Skeleton& s = one.now->model.skeleton;
    for (std::size_t i = 5; i < s.size(); i += 7) {
      if (s.parent[i] < 0) continue;
      Vec3 middle = (one.pose.position[i] + one.pose.position[s.parent[i]]) / 2.0f;
      Json found = picked(posed_scene, middle + Vec3(0.3f, 0.2f, 5), middle);
      ASSERT_FALSE(found.is_null());
      Vec3 at(found["point"][0], found["point"][1], found["point"][2]);
      if (glm::distance(at, middle) > 0.01f) continue;  // something stands before it
      ++met;
      EXPECT_EQ(found["plant"].get<std::size_t>(), one.plant);
      Branching plant{s.parent, one.axes};
      BranchPlace place =
          *find_place(plant, axis_starts(plant), *parse_address(found["at"].get<std::string>()));
      Vec3 there = glm::mix(s.position[s.parent[place.node]], s.position[place.node], place.within);
      EXPECT_LT(glm::distance(there, at), 1e-3f);
      EXPECT_EQ(found["hangs"].size() % 8, 0u);
      EXPECT_GE(found["beam"].size(), 8u);
    }
  }
  EXPECT_GT(met, 10);
}

TEST(Pick, NothingIsMetBeside) {
  Scene scene = scene_of(kCorals);
  PosedScene posed_scene = *posed(scene, 0);
  EXPECT_TRUE(picked(posed_scene, Vec3(0, 30, 5), Vec3(0, 30, 0)).is_null());
  EXPECT_TRUE(picked(posed_scene, Vec3(0, 1, 5), Vec3(0, 1, 5)).is_null());
  Vec3 at = posed_scene.specimens[0].pose.position[3];
  EXPECT_TRUE(picked(posed_scene, at + Vec3(0, 0, 5), at, 7).is_null()) << "of another entry";
}

TEST(Pick, TellsTheAgeOfATree) {
  Scene scene = scene_of(R"({"kind": "tree", "years": 6, "place": {"at": [[0, 0]], "size_variation": 0}})");
  PosedScene posed_scene = *posed(scene, 0);
  Vec3 at = posed_scene.specimens[0].pose.position[2];
  Json found = picked(posed_scene, at + Vec3(0, 0, 9), at);
  ASSERT_FALSE(found.is_null());
  EXPECT_NEAR(found["year"].get<double>(), 6.5, 0.6);
}

}  // namespace
}  // namespace frond
