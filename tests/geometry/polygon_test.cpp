#include "geometry/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

#include "core/seed.h"

namespace frond {
namespace {

using Outline = std::vector<DVec3>;

/// Cuts an outline and finds that its triangles look its way and together are as large as it is.
void expect_covered(const Outline& outline, const char* what) {
  SCOPED_TRACE(what);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  ASSERT_TRUE(triangulate_polygon(outline, triangles));
  EXPECT_EQ(triangles.size(), outline.size() - 2);
  DVec3 area = polygon_area(outline), normal = glm::normalize(area);
  double sum = 0;
  for (auto [a, b, c] : triangles) {
    double one = 0.5 * glm::dot(glm::cross(outline[b] - outline[a], outline[c] - outline[a]), normal);
    EXPECT_GT(one, -1e-9 * glm::length(area));
    sum += std::abs(one);
  }
  EXPECT_NEAR(sum, glm::length(area), 1e-7 * glm::length(area));
}

/// A flat outline somewhere in space.
Outline in_a_plane(const std::vector<glm::dvec2>& flat, Seed seed) {
  auto random = [&](std::uint64_t i) { return seed.child(i).range(-1, 1); };
  DVec3 x = glm::normalize(DVec3(random(0), random(1), random(2)) + 1e-3);
  DVec3 y = glm::normalize(glm::cross(x, DVec3(random(3), random(4), random(5)) + 1e-3));
  DVec3 at = 1000.0 * DVec3(random(6), random(7), random(8));
  double size = std::pow(10, 3 * random(9));
  Outline outline;
  for (const glm::dvec2& p : flat) outline.push_back(at + size * (p.x * x + p.y * y));
  return outline;
}

/// A star whose points reach out by chance.
std::vector<glm::dvec2> star(std::size_t corners, Seed seed) {
  std::vector<glm::dvec2> flat;
  for (std::size_t i = 0; i < corners; ++i) {
    double angle = 2 * kPi * static_cast<double>(i) / static_cast<double>(corners);
    double reach = seed.child(i).range(0.05, 1);
    flat.emplace_back(reach * std::cos(angle), reach * std::sin(angle));
  }
  return flat;
}

/// A square with some square holes in a row, each reached through a slit from the edge below it.
std::vector<glm::dvec2> with_windows(std::size_t holes) {
  std::vector<glm::dvec2> flat{{0, 0}};
  for (std::size_t i = 0; i < holes; ++i) {
    double x = (static_cast<double>(i) + 0.25) / static_cast<double>(holes),
           wide = 0.5 / static_cast<double>(holes);
    for (glm::dvec2 p :
         {glm::dvec2(x, 0), {x, 0.3}, {x, 0.7}, {x + wide, 0.7}, {x + wide, 0.3}, {x, 0.3}, {x, 0}})
      flat.push_back(p);
  }
  for (glm::dvec2 p : {glm::dvec2(1, 0), {1, 1}, {0, 1}}) flat.push_back(p);
  return flat;
}

std::vector<glm::dvec2> comb(int teeth) {
  std::vector<glm::dvec2> flat;
  for (int i = 0; i < teeth; ++i)
    for (glm::dvec2 p : {glm::dvec2(i, 0), {i + 0.5, 0}, {i + 0.5, 5}, {i + 1, 5}}) flat.push_back(p);
  flat.emplace_back(teeth, 6), flat.emplace_back(0, 6);
  return flat;
}

std::vector<glm::dvec2> spiral(int corners) {
  std::vector<glm::dvec2> flat;
  auto at = [](double turn, double off) {
    double reach = 1 + turn + off;
    return glm::dvec2(reach * std::cos(turn), reach * std::sin(turn));
  };
  for (int i = 0; i < corners; ++i) flat.push_back(at(0.2 * i, 0));
  for (int i = corners; i-- > 0;) flat.push_back(at(0.2 * i, 0.8));
  if (glm::dvec2 a = flat[0], b = flat[1]; a.x * b.y - a.y * b.x < 0) std::ranges::reverse(flat);
  return flat;
}

TEST(Polygon, ConcaveOnesAreNotCutWrongly) {
  Seed seed{7};
  for (std::uint64_t i = 0; i < 40; ++i) {
    Seed own = seed.child(i);
    expect_covered(in_a_plane(star(4 + i, own), own), "star");
    expect_covered(in_a_plane(comb(1 + static_cast<int>(i % 9)), own), "comb");
    expect_covered(in_a_plane(spiral(4 + static_cast<int>(i)), own), "spiral");
    expect_covered(in_a_plane(with_windows(1 + i % 6), own), "windows through slits");
  }
}

TEST(Polygon, LargeOnesAreCutToo) {
  expect_covered(in_a_plane(star(900, Seed{1}), Seed{2}), "star");
  expect_covered(in_a_plane(comb(300), Seed{3}), "comb");
  expect_covered(in_a_plane(with_windows(60), Seed{4}), "windows through slits");
}

/// The least total length of the cuts of a convex outline between two of its corners, by trying all of them.
double shortest_cuts(const std::vector<glm::dvec2>& flat, std::size_t from, std::size_t to) {
  if (to < from + 2) return 0;
  double least = 1e30;
  for (std::size_t apex = from + 1; apex < to; ++apex) {
    double cuts = shortest_cuts(flat, from, apex) + shortest_cuts(flat, apex, to);
    if (apex > from + 1) cuts += glm::distance(flat[from], flat[apex]);
    if (to > apex + 1) cuts += glm::distance(flat[apex], flat[to]);
    least = std::min(least, cuts);
  }
  return least;
}

TEST(Polygon, CutsAreTheShortestOfAll) {
  for (std::size_t corners = 4; corners <= 9; ++corners) {
    std::vector<glm::dvec2> flat;
    double outline = 0, sides = 0;
    for (std::size_t i = 0; i < corners; ++i) {
      double angle = 2 * kPi * (static_cast<double>(i) + Seed{corners}.child(i).range(0, 0.6)) /
                     static_cast<double>(corners);
      flat.emplace_back(3 * std::cos(angle), std::sin(angle));
    }
    for (std::size_t i = 0; i < corners; ++i) outline += glm::distance(flat[i], flat[(i + 1) % corners]);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    ASSERT_TRUE(triangulate_polygon(in_a_plane(flat, Seed{corners}), triangles));
    for (const auto& triangle : triangles)
      for (std::size_t k = 0; k < 3; ++k)
        sides += glm::distance(flat[triangle[k]], flat[triangle[(k + 1) % 3]]);
    EXPECT_NEAR((sides - outline) / 2, shortest_cuts(flat, 0, corners - 1), 1e-6) << corners;
  }
}

TEST(Polygon, AWallWithADoorKeepsItOpen) {
  Outline wall;
  for (glm::dvec2 p : {glm::dvec2(0, 0), {3, 0}, {3, 2}, {4, 2}, {4, 0}, {8, 0}, {8, 3}, {0, 3}})
    wall.emplace_back(p.x, p.y, 0);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  ASSERT_TRUE(triangulate_polygon(wall, triangles));
  for (auto [a, b, c] : triangles) {
    DVec3 middle = (wall[a] + wall[b] + wall[c]) / 3.0;
    EXPECT_FALSE(middle.x > 3 && middle.x < 4 && middle.y < 2);
  }
  expect_covered(wall, "wall");
}

}  // namespace
}  // namespace frond
