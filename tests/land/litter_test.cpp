#include "land/litter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/far.h"

namespace frond {
namespace {

// How many pieces there are of those whose number is so: a piece is what triangles join.
std::size_t pieces_between(const Surface& s, float low, float high) {
  Pieces pieces = pieces_of(s);
  std::set<std::uint32_t> found;
  for (std::size_t v = 0; v < s.uv.size(); ++v)
    if (s.uv[v].x >= low && s.uv[v].x < high) found.insert(pieces.of[v]);
  return found.size();
}

TEST(Litter, has_as_many_leaves_and_twigs_as_asked) {
  LitterShape shape{.side = 0.5, .leaf = 0.08, .leaves = 400, .twigs = 20, .twig = 0.2};
  Surface s = litter_surface(shape, Seed{4});
  EXPECT_EQ(s.find_fault(), "");
  EXPECT_EQ(pieces_between(s, 0, 64), 100u);
  EXPECT_EQ(pieces_between(s, 64, 128), 5u);
}

TEST(Litter, lies_flat_within_its_square) {
  LitterShape shape{.side = 0.5, .leaf = 0.08, .leaves = 400, .twigs = 20, .twig = 0.2};
  for (const Vec3& p : litter_surface(shape, Seed{5}).position) {
    EXPECT_LT(std::max(std::abs(p.x), std::abs(p.z)), 0.25 + 0.2);
    EXPECT_LT(p.y, 0.09);
  }
}

TEST(Litter, that_rolls_lies_on_the_ground_and_not_in_it) {
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    LitterShape shape{.side = 0.5, .leaf = 0.12, .leaves = 400, .twigs = 20, .twig = 0.9};
    Surface s = litter_surface(shape, Seed{seed});
    float lowest = 1;
    for (const Vec3& p : s.position) lowest = std::min(lowest, p.y);
    EXPECT_GT(lowest, -0.005);
    EXPECT_LT(lowest, 0.001);
  }
}

TEST(Litter, of_another_seed_lies_otherwise) {
  LitterShape shape;
  EXPECT_EQ(litter_surface(shape, Seed{1}).position, litter_surface(shape, Seed{1}).position);
  EXPECT_NE(litter_surface(shape, Seed{1}).position, litter_surface(shape, Seed{2}).position);
}

TEST(Litter, may_be_none) {
  EXPECT_TRUE(litter_surface({.leaves = 0, .twigs = 0}, Seed{1}).triangle.empty());
}

TEST(Moss, is_a_dome_of_upright_shoots) {
  Surface s = moss_surface(0.5, Seed{2});
  EXPECT_EQ(s.find_fault(), "");
  double middle = 0, rim = 0;
  int inside = 0, outside = 0;
  for (std::size_t i = 0; i < s.position.size(); ++i) {
    double r = std::hypot(s.position[i].x, s.position[i].z);
    EXPECT_LT(r, 0.25 + 0.02);
    EXPECT_GT(s.normal[i].y, 0.3);
    if (s.uv[i].x < 1) continue;
    if (r < 0.08) middle += s.position[i].y, ++inside;
    if (r > 0.2) rim += s.position[i].y, ++outside;
  }
  EXPECT_GT(middle / inside, rim / outside + 0.005);
}

}  // namespace
}  // namespace frond
