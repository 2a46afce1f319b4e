#include "field/cubes.h"

#include <gtest/gtest.h>

#include <map>

#include "field/fused.h"

namespace frond {
namespace {

Cubes cubes_at(const Skeleton& s, double side) { return *cubes_of(boughs_of(s, 1), {.voxel = side}); }

/// The surface with the corners of faces that lie at one place made one.
Surface welded(Surface s) {
  std::map<std::array<int, 3>, std::uint32_t> index;
  for (auto& t : s.triangle)
    for (std::uint32_t& v : t) {
      Vec3 p = s.position[v] * 1e4f;
      auto key = std::array{static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y)),
                            static_cast<int>(std::lround(p.z))};
      v = index.try_emplace(key, v).first->second;
    }
  return s;
}

TEST(Cubes, of_a_thick_branch_fill_it) {
  Skeleton s;
  s.add({0, 0, 0}, 0.3f, Skeleton::kRoot, 0);
  s.add({0.1f, 1, 0.2f}, 0.3f, 0, 0);
  std::vector<std::uint32_t> cube;
  Surface surface = cubes_surface(cubes_at(s, 0.03), cube);
  EXPECT_EQ(surface.find_fault(), "");
  EXPECT_EQ(2 * cube.size(), surface.triangle.size());
  Closure c = measure(welded(surface));
  EXPECT_EQ(c.open, 0u);
  double exact = kPi * 0.09 * std::sqrt(1.05) + 4 * kPi / 3 * 0.027;
  EXPECT_NEAR(c.volume, exact, 0.02 * exact);
}

TEST(Cubes, of_twigs_thinner_than_a_cube_hang_together) {
  Cubes cubes = cubes_at(test_coral(4, 0.004), 0.02);
  std::map<std::array<int, 3>, std::size_t> at;
  for (std::size_t i = 0; i < cubes.size(); ++i) at[{cubes.cell[i].i, cubes.cell[i].j, cubes.cell[i].k}] = i;
  std::vector<bool> seen(cubes.size());
  std::vector<std::size_t> stack{0};
  std::size_t reached = 0;
  seen[0] = true;
  while (!stack.empty()) {
    Cell c = cubes.cell[stack.back()];
    stack.pop_back();
    ++reached;
    for (auto next : {std::array{c.i - 1, c.j, c.k},
                      {c.i + 1, c.j, c.k},
                      {c.i, c.j - 1, c.k},
                      {c.i, c.j + 1, c.k},
                      {c.i, c.j, c.k - 1},
                      {c.i, c.j, c.k + 1}})
      if (auto found = at.find(next); found != at.end() && !seen[found->second]) {
        seen[found->second] = true;
        stack.push_back(found->second);
      }
  }
  EXPECT_GT(cubes.size(), 500u);
  EXPECT_EQ(reached, cubes.size());
}

TEST(Cubes, show_a_face_just_where_there_is_no_neighbour) {
  Skeleton s;
  s.add({0, 0, 0}, 0.01f, Skeleton::kRoot, 0);
  s.add({0, 1, 0}, 0.01f, 0, 0);
  Cubes cubes = cubes_at(s, 0.1);
  EXPECT_EQ(cubes.size(), 11u);  // one column
  std::vector<std::uint32_t> cube;
  cubes_surface(cubes, cube);
  EXPECT_EQ(cube.size(), 4 * 11u + 2);
}

TEST(Cubes, past_the_limit_are_refused) {
  EXPECT_FALSE(cubes_of(boughs_of(test_coral(3), 1), {.voxel = 0.00001}));
}

}  // namespace
}  // namespace frond
