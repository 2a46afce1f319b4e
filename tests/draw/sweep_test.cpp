#include "draw/sweep.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/matrix.hpp>
#include <map>

#include "motion/unfold.h"
#include "shapes.h"

namespace frond {
namespace {

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

/// Where a point on the skin at node i is in the space of a chunk's pattern, away from where it was made.
float slide(const Skeleton& s, const Pose& pose, const Chunk& chunk, std::int32_t i, Vec3 side) {
  Vec3 skin = pose.position[i] + pose.turn[i] * side * (pose.radius[i] / s.radius[i]);
  Vec3 pattern = glm::inverse(chunk.matrix) * (skin - chunk.shift);
  return glm::distance(pattern, s.position[i] + side);
}

/// Which way is across a branch and at a right angle to a direction.
Vec3 across(const Skeleton& s, std::int32_t node, Vec3 direction) {
  std::int32_t below = s.parent[node];
  Vec3 along = below == Skeleton::kRoot ? Vec3(0, 1, 0) : s.position[node] - s.position[below];
  return glm::normalize(glm::cross(along, direction));
}

/// The most by which the pattern slides on a coral that sways and reaches, over a film; with `carried` false,
/// by which it would if chunks left it in space.
float most_slide(const ChunkOptions& options, bool carried, double stretch = 0) {
  Skeleton s = candelabrum(15, Seed{3});
  Motion motion = lively();
  motion.food.stretch = stretch;
  motion.growth = {};
  Pose pose;
  float most = 0;
  for (int frame = 0; frame < 96; frame += 3) {
    pose_skeleton(s, motion, frame / 24.0, pose);
    for (Chunk chunk : cut_chunks(s, pose, options)) {
      if (!carried) chunk.matrix = glm::mat3(1), chunk.shift = Vec3(0);
      // The node below the first one is the foot of the chunk's first segment.
      for (std::int32_t i = chunk.first - 1; i <= chunk.last; ++i) {
        std::int32_t node = i < chunk.first ? s.parent[chunk.first] : i;
        // Where it leaves another branch it is drawn little thicker than it goes on, and each of the two is
        // scaled along the direction to the food by itself.
        float thick = std::min(s.radius[node], 1.25f * s.radius[chunk.first]);
        if (stretch > 0 && i < chunk.first && node != i) continue;
        for (Vec3 direction : {Vec3(0.3f, 0.1f, 0.9f), Vec3(0.9f, -0.2f, -0.3f), Vec3(-0.8f, 0.1f, -0.5f)})
          most = std::max(most, slide(s, pose, chunk, node, across(s, node, direction) * thick));
      }
    }
  }
  return most;
}

TEST(Texture, SticksToTheSkin) {
  // Skin points are followed through the whole film.
  for (float tolerance : {0.006f, 0.003f}) {
    ChunkOptions options;
    options.tolerance = tolerance;
    EXPECT_LT(most_slide(options, true), 1.2f * tolerance);
    EXPECT_LT(most_slide(options, true, 1), 1.5f * tolerance) << "stretched toward the food";
  }
}

TEST(Texture, WouldSlideWithoutBeingCarried) { EXPECT_GT(most_slide({}, false), 0.1f); }

TEST(Youth, IsAtTheTips) {
  Skeleton s = trunk(21);
  Pose pose;
  pose_skeleton(s, Motion{}, 0, pose);
  EXPECT_FLOAT_EQ(youth(s, pose, s.longest(), 0.2f, 20), 1);
  EXPECT_FLOAT_EQ(youth(s, pose, s.longest(), 0.2f, 10), 0);
  EXPECT_GT(youth(s, pose, s.longest(), 0.2f, 18), 0.1f);
  EXPECT_FLOAT_EQ(youth(s, pose, s.longest(), 0, 20), 0);
}

TEST(Sweep, RingsLieAcrossTheBranch) {
  Skeleton rest;  // up, then a bend to the side
  std::int32_t node = rest.add(Vec3(1, 0, 0), 0.1f, Skeleton::kRoot, 0);
  for (int i = 1; i <= 4; ++i) node = rest.add(Vec3(1, 0.25f * static_cast<float>(i), 0), 0.1f, node, 0);
  for (int i = 1; i <= 4; ++i) node = rest.add(Vec3(1 + 0.25f * static_cast<float>(i), 1, 0), 0.1f, node, 0);
  for (std::size_t i = 1; i < rest.size(); ++i) rest.distance[i] = 0.25f * static_cast<float>(i);
  Chunk side{5, 8};
  side.anchor = 6;
  lay_along(rest, side);
  // The pattern's height y is the way along the branch, whatever side of it.
  for (float s : {1.0f, 1.5f, 2.0f}) {
    Vec3 on = side.shift + side.matrix * Vec3(0, s, 0);
    EXPECT_LT(glm::distance(on, Vec3(s, 1, 0)), 1e-4f) << on.x << " " << on.y;
  }
  EXPECT_NEAR(glm::determinant(side.matrix), 1, 1e-5);
}

TEST(Sweep, AFootHoldsNotItsFirstNodeNorIsItAsThickAsTheTrunk) {
  Skeleton rest;  // a trunk, and a twig that leaves it
  std::int32_t trunk = rest.add(Vec3(0, 0, 0), 0.1f, Skeleton::kRoot, 0);
  rest.add(Vec3(0, 0.5f, 0), 0.1f, trunk, 0);
  Pose pose;
  for (float length : {0.3f, 0.02f}) {
    Skeleton forked = rest;
    std::int32_t first = forked.add(Vec3(length, 0, 0), 0.01f, trunk, 0);
    pose_skeleton(forked, {}, 0, pose);
    float foot = foot_radius(forked, pose, first);
    EXPECT_LT(foot, 0.02f);
    EXPECT_LT(std::abs(foot - 0.01f), length);
  }
}

}  // namespace
}  // namespace frond
