#include "motion/unfold.h"

#include <algorithm>

namespace frond {

float unfolded(float birth, float front, double ripen) {
  // What is born last still has all of `ripen` left.
  return smooth_step(0.0f, static_cast<float>(std::max(ripen, 1e-3)), front - birth);
}

Surface posed_blades(const Skeleton& rest, const Pose& pose, const Blades& all, double ripen,
                     const std::function<bool(std::size_t)>& wanted) {
  Surface s;
  std::size_t triangle = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    // The triangles follow each other as the blades do.
    std::size_t first = triangle;
    while (triangle < all.surface.triangle.size() && all.surface.triangle[triangle][0] < all.first[i + 1])
      ++triangle;
    if (!wanted(i)) continue;
    float size = unfolded(all.birth[i], pose.front, ripen);
    if (size < kUnfoldedLeast) continue;
    Quat turn = carried_turn(pose, all.node[i]);
    Vec3 foot = carried(rest, pose, all.node[i], all.foot[i]);
    auto offset = static_cast<std::uint32_t>(s.position.size()) - all.first[i];
    for (std::uint32_t k = all.first[i]; k < all.first[i + 1]; ++k) {
      s.position.push_back(foot + turn * ((all.surface.position[k] - all.foot[i]) * size));
      s.normal.push_back(turn * all.surface.normal[k]);
      s.uv.push_back(all.surface.uv[k]);
    }
    for (; first < triangle; ++first) {
      auto [a, c, d] = all.surface.triangle[first];
      s.triangle.push_back({a + offset, c + offset, d + offset});
    }
  }
  return s;
}

}  // namespace frond
