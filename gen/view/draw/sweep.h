#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/skeleton.h"
#include "motion/motion.h"

namespace frond {

/// A stretch of one branch that is written as one sphere_sweep: the nodes first..last of a skeleton, which
/// follow each other, and the node below `first`. Neighbours share a node.
struct Chunk {
  std::int32_t first, last;
  /// Where the texture of the stretch has gone with the moving skin: a point x of the rest shape's pattern
  /// lies at shift + matrix * x. The identity while nothing moves.
  glm::mat3 matrix{1};
  Vec3 shift{0};
  Quat turn{1, 0, 0, 0};     ///< the part of the matrix that is motion; the rest is the branch thickening
  std::int32_t anchor = -1;  ///< the node that the pattern goes by
  /// How young the skin is at the node below `first` and at the end: 1 at a growing tip .. 0 farther below
  /// than the young length.
  float young_from = 0, young_to = 0;

  bool moved() const { return matrix != glm::mat3(1) || shift != Vec3(0); }
};

struct ChunkOptions {
  int nodes = 12;              ///< at most so many in one chunk, 2 or more
  float tolerance = 0.003f;    ///< metres by which the pattern may slide on the skin
  float young_length = 0.08f;  ///< metres below a tip in which the skin is young
  float thin =
      0;  ///< metres: where a chunk is thinner its pattern is too small to be seen and need not ride on it
  std::span<const std::int32_t> color =
      {};  ///< of each node; a chunk has one colour; empty: all have the same
};

/// Cuts the branches that growth has reached into chunks as short as the options ask.
///
/// Patterns live in space. So that pores stay on a skin that sways and thickens, each chunk carries its
/// pattern along: turned as its middle node is, and stretched across the branch as the branch has thickened.
std::vector<Chunk> cut_chunks(const Skeleton& rest, const Pose& pose, const ChunkOptions& options);

/// Cuts the nodes first..end - 1 alone, which must be whole chains, into chunks. `longest` is
/// Skeleton::longest().
std::vector<Chunk> cut_chunks(const Skeleton& rest, const Pose& pose, const ChunkOptions& options,
                              float longest, std::int32_t first, std::int32_t end);

/// How thick a branch is drawn where it leaves another, at the node below its node `first`: little thicker
/// than it goes on, or the fork would swell.
float foot_radius(const Skeleton& rest, const Pose& pose, std::int32_t first);

/// Takes the pattern of a chunk, which lies along the y axis, to the branch: its y is the way along the
/// branch from the base, and then it goes with the moving skin.
void lay_along(const Skeleton& rest, Chunk& chunk);

/// How far the skin at node `i` slides under the pattern of a chunk it is in, or at the foot of, as the
/// branch moves; metres. Thickening stretches the pattern with the skin at the anchor, and is not counted.
float pattern_drift(const Skeleton& rest, const Pose& pose, const Chunk& chunk, std::int32_t i);

}  // namespace frond
