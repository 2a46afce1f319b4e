#include "emit/sweep.h"

#include <gtest/gtest.h>

#include <glm/matrix.hpp>
#include <map>

#include "shapes.h"

namespace frond {
namespace {

Motion lively() {
  Motion motion;
  motion.film_length = 4;
  motion.growth = {0, 2, 0, 0.3};
  motion.wave.amplitude = radians(16.0);
  motion.food.strength = 1.4;
  motion.food.position = Animated<Vec3>(
      std::vector<Animated<Vec3>::Key>{{0, Vec3(2, 1, 0)}, {2, Vec3(0, 2, 2)}, {4, Vec3(-2, 1, 0)}});
  return motion;
}

TEST(CutChunks, CoversEachReachedSegmentOnce) {
  Skeleton s = candelabrum(15, Seed{1});
  Motion motion = lively();
  Pose pose;
  for (double time : {0.3, 0.9, 3.0}) {
    pose_skeleton(s, motion, time, pose);
    std::vector<int> covered(s.size(), 0);
    for (const Chunk& chunk : cut_chunks(s, pose, {})) {
      EXPECT_LE(chunk.last - chunk.first + 2, ChunkOptions{}.nodes);
      for (std::int32_t i = chunk.first; i <= chunk.last; ++i) {
        ++covered[i];
        if (i > chunk.first) {
          EXPECT_EQ(s.parent[i], i - 1);
        }
      }
    }
    for (std::size_t i = 1; i < s.size(); ++i) EXPECT_EQ(covered[i], s.birth[s.parent[i]] < pose.front) << i;
  }
}

TEST(CutChunks, MovesNothingAtRest) {
  Skeleton s = candelabrum(5, Seed{2});
  Pose pose;
  pose_skeleton(s, Motion{}, 0, pose);
  for (const Chunk& chunk : cut_chunks(s, pose, {})) EXPECT_FALSE(chunk.moved());
}

TEST(Texture, SticksToTheSkin) {
  // Skin points are followed through the whole film: where each is in the space of the pattern may not differ
  // from where it was made by more than the tolerance allows.
  Skeleton s = candelabrum(15, Seed{3});
  Motion motion = lively();
  ChunkOptions options;
  options.tolerance = 0.004f;
  Pose pose;
  int followed = 0;
  for (int frame = 0; frame < 96; frame += 3) {
    pose_skeleton(s, motion, frame / 24.0, pose);
    for (const Chunk& chunk : cut_chunks(s, pose, options)) {
      for (std::int32_t i = chunk.first; i <= chunk.last; ++i) {
        if (s.birth[i] > pose.front || chunk.first == chunk.last) continue;
        Vec3 along = glm::normalize(s.position[i] - s.position[s.parent[i]]);
        Vec3 side = glm::normalize(glm::cross(along, Vec3(0.3f, 0.1f, 0.9f))) * s.radius[i];
        Vec3 skin = pose.position[i] + pose.turn[i] * side * (pose.radius[i] / s.radius[i]);
        Vec3 pattern = glm::inverse(chunk.matrix) * (skin - chunk.shift);
        EXPECT_LT(glm::distance(pattern, s.position[i] + side), 1.6f * options.tolerance)
            << "node " << i << ", frame " << frame;
        ++followed;
      }
    }
  }
  EXPECT_GT(followed, 1500);
}

TEST(Texture, WouldSlideWithoutBeingCarried) {
  // The test above can fail: the pattern of the rest shape, left in space, slides by far more.
  Skeleton s = candelabrum(15, Seed{3});
  Pose pose;
  pose_skeleton(s, lively(), 3, pose);
  float most = 0;
  for (std::size_t i = 0; i < s.size(); ++i)
    most = std::max(most, glm::distance(pose.position[i], s.position[i]));
  EXPECT_GT(most, 0.1f);
}

TEST(Youth, IsAtTheTips) {
  Skeleton s = trunk(21);
  Pose pose;
  pose_skeleton(s, Motion{}, 0, pose);
  EXPECT_FLOAT_EQ(youth(s, pose, s.longest(), 0.2f, 20), 1);
  EXPECT_FLOAT_EQ(youth(s, pose, s.longest(), 0.2f, 10), 0);
  EXPECT_GT(youth(s, pose, s.longest(), 0.2f, 18), 0.1f);
  EXPECT_FLOAT_EQ(youth(s, pose, s.longest(), 0, 20), 0);
}

}  // namespace
}  // namespace frond
