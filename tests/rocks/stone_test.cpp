#include "rocks/stone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace frond {
namespace {

TEST(Stone, IsClosedAndWellFormed) {
  for (int detail = 0; detail <= 3; ++detail) {
    Surface s = stone_surface({Seed{4}}, detail);
    EXPECT_EQ(s.find_fault(), "");
    EXPECT_EQ(s.triangle.size(), 20u << (2 * detail));
    // Each edge is run once in each direction.
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (auto [a, b, c] : s.triangle) ++edges[{a, b}], ++edges[{b, c}], ++edges[{c, a}];
    for (auto [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
    // Outward: its volume is positive.
    double volume = 0;
    for (auto [a, b, c] : s.triangle)
      volume += glm::dot(s.position[a], glm::cross(s.position[b], s.position[c])) / 6;
    EXPECT_GT(volume, 0.05);
  }
}

}  // namespace
}  // namespace frond
