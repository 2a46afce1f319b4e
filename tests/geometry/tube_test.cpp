#include "geometry/tube.h"

#include <gtest/gtest.h>

#include <map>

#include "shapes.h"

namespace frond {
namespace {

TubeMesh tubes(const Skeleton& s, int sides = 12, float front = 2) {
  return branch_tubes(s, s.position, s.radius, front, sides);
}

/// Edges without a counterpart, vertices at one place taken as one; and the volume.
std::pair<int, double> open_edges(const Surface& s) {
  std::map<std::array<float, 3>, int> index;
  std::vector<int> welded;
  for (Vec3 p : s.position)
    welded.push_back(index.try_emplace({p.x, p.y, p.z}, static_cast<int>(index.size())).first->second);
  std::map<std::pair<int, int>, int> edges;
  double volume = 0;
  for (const auto& t : s.triangle) {
    for (std::size_t k = 0; k < 3; ++k) {
      int a = welded[t[k]], b = welded[t[(k + 1) % 3]];
      edges[std::minmax(a, b)] += a < b ? 1 : -1;
    }
    volume += glm::dot(s.position[t[0]], glm::cross(s.position[t[1]], s.position[t[2]])) / 6;
  }
  int open = 0;
  for (const auto& [edge, balance] : edges) open += balance != 0;
  return {open, volume};
}

TEST(Tubes, are_closed_and_face_outward) {
  Skeleton s = candelabrum(5, Seed{3});
  TubeMesh mesh = tubes(s);
  EXPECT_EQ(mesh.surface.check(), "");
  EXPECT_EQ(mesh.node.size(), mesh.surface.position.size());
  auto [open, volume] = open_edges(mesh.surface);
  EXPECT_EQ(open, 0);
  EXPECT_GT(volume, 0);
}

TEST(Tubes, have_the_volume_of_the_branch) {
  Skeleton s = trunk(30, 2, 0.1f);
  auto [open, volume] = open_edges(tubes(s, 48).surface);
  double exact = kPi * 0.01 * 2 + 2 * kPi / 3 * 0.001 + kPi / 3 * 0.01 * 0.05;  // a half ball, a cone below
  EXPECT_NEAR(volume, exact, 0.01 * exact);
}

TEST(Tubes, are_smooth_along_the_branch) {
  // A spiral: rings must follow it without twisting round it.
  Skeleton s;
  for (int i = 0; i < 60; ++i) {
    float t = 0.2f * static_cast<float>(i);
    s.add({std::cos(t), 0.1f * t, std::sin(t)}, 0.05f, i - 1, 0);
  }
  Surface surface = tubes(s, 16).surface;
  for (const auto& t : surface.triangle) {
    Vec3 face = glm::cross(surface.position[t[1]] - surface.position[t[0]],
                           surface.position[t[2]] - surface.position[t[0]]);
    if (glm::length(face) < 1e-9f) continue;
    for (std::uint32_t v : t) EXPECT_GT(glm::dot(glm::normalize(face), surface.normal[v]), 0.4f);
  }
}

TEST(Tubes, stop_where_growth_has_come_to) {
  Skeleton s = trunk(20);
  TubeMesh half = tubes(s, 8, 0.5f);
  for (std::int32_t node : half.node)
    EXPECT_LT(s.birth[static_cast<std::size_t>(s.parent[static_cast<std::size_t>(node)])], 0.5f);
  EXPECT_TRUE(tubes(s, 8, 0).surface.triangle.empty());
}

}  // namespace
}  // namespace frond
