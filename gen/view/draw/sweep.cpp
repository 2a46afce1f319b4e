#include "draw/sweep.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "motion/unfold.h"

namespace frond {

namespace {

/// Whether growth has reached the segment that ends at node i.
bool reached(const Skeleton& rest, const Pose& pose, std::int32_t i) {
  return rest.birth[rest.parent[i]] < pose.front;
}

float thickened(const Skeleton& rest, const Pose& pose, std::int32_t i) {
  return std::max(pose.radius[i] / rest.radius[i], 1e-3f);
}

/// How many times as long a branch is at a node as at rest.
float stretched(const Pose& pose, std::int32_t i) { return pose.stretch.empty() ? 1 : pose.stretch[i]; }

/// Scales by `across` the branch and `along` it.
glm::mat3 scaled_along(const Skeleton& rest, const Chunk& chunk, float across, float along) {
  Vec3 way = rest.position[chunk.last] - rest.position[rest.parent[chunk.first]];
  float length2 = glm::dot(way, way);
  glm::mat3 scale(across);
  return length2 > 0 ? scale + glm::outerProduct(way, way) * ((along - across) / length2) : scale;
}

/// The pattern's way with the middle node of the chunk.
void carry(const Skeleton& rest, const Pose& pose, Chunk& chunk) {
  std::int32_t middle = (chunk.first + chunk.last) / 2;
  // A growing tip has not come to its node yet: there the pattern goes by the node below.
  while (middle > chunk.first && rest.birth[middle] > pose.front) --middle;
  chunk.anchor = rest.birth[middle] > pose.front ? rest.parent[middle] : middle;
  chunk.turn = pose.turn[middle];
  float thick = thickened(rest, pose, chunk.anchor), longer = stretched(pose, chunk.anchor);
  bool still = chunk.turn == Quat(1, 0, 0, 0) && std::abs(thick - 1) < 1e-6f && longer == 1 &&
               glm::distance(pose.position[chunk.anchor], rest.position[chunk.anchor]) < 1e-5f;
  if (still) return;
  chunk.matrix = glm::mat3_cast(chunk.turn) * scaled_along(rest, chunk, thick, longer);
  chunk.shift = pose.position[chunk.anchor] - chunk.matrix * rest.position[chunk.anchor];
}

class Cutter {
 public:
  Cutter(const Skeleton& rest, const Pose& pose, const ChunkOptions& options, float longest,
         std::vector<Chunk>& out)
      : rest_(rest), pose_(pose), options_(options), longest_(longest), out_(out) {}

  /// One chunk of first..last, or halves of it where the pattern would slide too far. `end` is the last node
  /// that growth has reached; the halving does not depend on it, so that cuts stay where they are.
  void cut(std::int32_t first, std::int32_t last, std::int32_t end) {
    if (first > end) return;
    Chunk chunk{first, last};
    carry(rest_, pose_, chunk);
    if (first == last || fits(chunk, std::min(last, end))) {
      chunk.last = std::min(last, end);
      chunk.young_from = youth(rest_.parent[first]);
      chunk.young_to = youth(chunk.last);
      out_.push_back(chunk);
      return;
    }
    std::int32_t middle = (first + last) / 2;
    cut(first, middle, end);
    cut(middle + 1, last, end);
  }

 private:
  float youth(std::int32_t i) const { return frond::youth(rest_, pose_, longest_, options_.young_length, i); }

  bool fits(const Chunk& chunk, std::int32_t end) const {
    if (!chunk.moved() || rest_.radius[chunk.first] < options_.thin) return true;
    if (pattern_drift(rest_, pose_, chunk, rest_.parent[chunk.first]) > options_.tolerance) return false;
    for (std::int32_t i = chunk.first; i <= end; ++i)
      if (pattern_drift(rest_, pose_, chunk, i) > options_.tolerance) return false;
    return true;
  }

  const Skeleton& rest_;
  const Pose& pose_;
  const ChunkOptions& options_;
  float longest_;
  std::vector<Chunk>& out_;
};

}  // namespace

float pattern_drift(const Skeleton& rest, const Pose& pose, const Chunk& chunk, std::int32_t i) {
  if (rest.birth[i] > pose.front) return 0;  // the tip is new skin
  Vec3 rested = rest.position[i] - rest.position[chunk.anchor];
  if (!pose.stretch.empty()) rested = scaled_along(rest, chunk, 1, stretched(pose, chunk.anchor)) * rested;
  Vec3 center = pose.position[chunk.anchor] + chunk.turn * rested - pose.position[i];
  // The angle between the two turns; a skin point comes away by no more than its radius times that.
  Quat apart = chunk.turn * glm::conjugate(pose.turn[i]);
  float angle = 2 * std::asin(std::min(glm::length(Vec3(apart.x, apart.y, apart.z)), 1.0f));
  return glm::length(center) + angle * pose.radius[i];
}

float foot_radius(const Skeleton& rest, const Pose& pose, std::int32_t first) {
  std::int32_t below = rest.parent[first];
  float next = pose.radius[first], length = glm::distance(pose.position[below], pose.position[first]);
  return cone_radius(std::min(pose.radius[below], 1.25f * next), next, length);
}

void lay_along(const Skeleton& rest, Chunk& chunk) {
  Vec3 direction = rest.position[chunk.last] - rest.position[rest.parent[chunk.first]];
  float length = glm::length(direction);
  if (!(length > 0)) return;
  direction /= length;
  Vec3 up(0, 1, 0), axis = glm::cross(up, direction);
  float s = glm::length(axis);
  Quat turn = s > 1e-6f         ? glm::angleAxis(std::atan2(s, direction.y), axis / s)
              : direction.y > 0 ? Quat(1, 0, 0, 0)
                                : glm::angleAxis(static_cast<float>(kPi), Vec3(1, 0, 0));
  glm::mat3 laid = glm::mat3_cast(turn);
  Vec3 at = rest.position[chunk.anchor] - direction * rest.distance[chunk.anchor];
  chunk.shift += chunk.matrix * at;
  chunk.matrix = chunk.matrix * laid;
}

std::vector<Chunk> cut_chunks(const Skeleton& rest, const Pose& pose, const ChunkOptions& options) {
  return cut_chunks(rest, pose, options, rest.longest(), 0, static_cast<std::int32_t>(rest.size()));
}

std::vector<Chunk> cut_chunks(const Skeleton& rest, const Pose& pose, const ChunkOptions& options,
                              float longest, std::int32_t first, std::int32_t n) {
  std::vector<Chunk> chunks;
  Cutter cutter(rest, pose, options, longest, chunks);
  for (std::int32_t start = first; start < n;) {
    if (rest.parent[start] == Skeleton::kRoot) {
      ++start;
      continue;
    }
    std::int32_t stop = start + 1;
    auto goes_on = [&] { return options.color.empty() || options.color[stop] == options.color[start]; };
    while (stop < n && rest.parent[stop] == stop - 1 && stop - start < options.nodes - 1 && goes_on()) ++stop;
    std::int32_t end = start - 1;
    while (end + 1 < stop && reached(rest, pose, end + 1)) ++end;
    cutter.cut(start, stop - 1, end);
    start = stop;
  }
  return chunks;
}

}  // namespace frond
