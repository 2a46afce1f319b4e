#include "draw/organs.h"

#include <gtest/gtest.h>

#include <set>

#include "motion/unfold.h"
#include "scene_at.h"

namespace frond {
namespace {

TEST(DrawnOrgans, HoldsEachUnfoldedOrganOnceAndByItsLook) {
  Scene scene = scene_at("presets/lsystems/plants-1.24.json");
  bool any = false;
  for (const Specimen& s : scene.specimens) {
    const Organs& organs = s.model.organs;
    Pose pose;
    pose_specimen(s, 0, pose);
    DrawnOrgans drawn(s, s.model, pose, 0);
    std::set<std::uint32_t> seen;
    for (const OrganGroup& group : drawn.groups) {
      const Prototype& prototype = s.model.prototypes[group.prototype];
      EXPECT_FALSE(drawn.organs(group).empty());
      for (std::uint32_t i : drawn.organs(group)) {
        EXPECT_TRUE(seen.insert(i).second) << "organ " << i << " is in two groups";
        EXPECT_EQ(organs.prototype[i], group.prototype);
        EXPECT_EQ(color_index(organs.color[i], prototype.colors.size()), group.color);
        EXPECT_EQ(leaf_shade(organs.id[i]), group.shade);
      }
      for (std::size_t k = 0; k < drawn.organs(group).size(); ++k)
        EXPECT_LE(drawn.places(group)[k].scale.x, organs.scale[drawn.organs(group)[k]].x);
    }
    std::size_t unfolded_ones = 0;
    for (float birth : organs.birth)
      unfolded_ones += unfolded(birth, pose.front, unfold_time(s.motion)) >= kUnfoldedLeast;
    EXPECT_EQ(seen.size(), unfolded_ones);
    any |= !seen.empty();
  }
  EXPECT_TRUE(any);
}

TEST(DrawnOrgans, GoFromTheColourOfTheBudToTheirOwn) {
  Specimen s;
  s.motion.growth = {.start = 0, .duration = 1, .ripen = 1};
  Prototype leaf;
  leaf.colors = {{0, 1, 0}};
  leaf.bud = Color{1, 0, 0};
  s.model.prototypes = {leaf};
  Organs& o = s.model.organs;
  o.prototype = {0}, o.position = {Vec3(0)}, o.turn = {Quat(1, 0, 0, 0)}, o.scale = {Vec3(1)};
  o.node = {Skeleton::kRoot}, o.birth = {0}, o.color = {0}, o.id = {1};
  float before = 2;
  for (double time : {0.15, 0.3, 2.0}) {
    Pose pose;
    pose_specimen(s, time, pose);
    DrawnOrgans drawn(s, s.model, pose, time);
    ASSERT_EQ(drawn.groups.size(), 1u) << time;
    EXPECT_LT(drawn.groups[0].tint.red, before) << time;
    before = drawn.groups[0].tint.red;
  }
  EXPECT_EQ(before, 0);
}

}  // namespace
}  // namespace frond
