#include "geometry/tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "shapes.h"

namespace frond {
namespace {

TEST(Tubes, GoRoundTheirBranches) {
  Skeleton s = candelabrum(5, Seed{2});
  Surface tubes = tube_surface(s, {});
  EXPECT_EQ(tubes.find_fault(), "");
  ASSERT_EQ(tubes.uv.size(), tubes.position.size());
  for (std::size_t i = 0; i < tubes.position.size(); ++i) {
    float nearest = 1e9f;
    for (std::size_t k = 1; k < s.size(); ++k) {
      Vec3 a = s.position[s.parent[k]], way = s.position[k] - a;
      float t = glm::clamp(glm::dot(tubes.position[i] - a, way) / glm::dot(way, way), 0.0f, 1.0f);
      nearest = std::min(nearest, glm::distance(tubes.position[i], a + way * t));
    }
    EXPECT_LT(nearest, 0.06f);
    EXPECT_NEAR(glm::length(tubes.normal[i]), 1, 1e-4);
  }
}

TEST(Tubes, HaveTheAreaOfTheirCylinder) {
  Skeleton s = trunk(20, 2, 0.1f);
  TubeShape fine;
  fine.side = 0.01;
  Surface tube = tube_surface(s, fine);
  double area = 0;
  for (auto [a, b, c] : tube.triangle) {
    Vec3 normal = glm::cross(tube.position[b] - tube.position[a], tube.position[c] - tube.position[a]);
    area += 0.5 * glm::length(normal);
    EXPECT_GT(glm::dot(normal, tube.normal[a] + tube.normal[b] + tube.normal[c]), 0);  // all face outward
  }
  EXPECT_NEAR(area, 2 * kPi * 0.1 * 2, 0.06);
}

TEST(Tubes, ThePictureGoesRoundAWholeNumberOfTimesAndOnAlong) {
  Skeleton s = candelabrum(4, Seed{3});
  TubeShape shape;
  shape.wrap = 0.05;
  shape.aspect = 2;
  Surface tubes = tube_surface(s, shape);
  double round = 0;
  for (auto [a, b, c] : tubes.triangle) {
    for (auto [i, k] : {std::pair{a, b}, std::pair{b, c}}) {
      // No triangle runs back over the seam.
      EXPECT_LT(std::abs(tubes.uv[i].x - tubes.uv[k].x), 0.8f);
      EXPECT_LT(std::abs(tubes.uv[i].y - tubes.uv[k].y), 3.0f);
    }
  }
  for (const Vec2& uv : tubes.uv) round = std::max<double>(round, uv.x);
  EXPECT_EQ(round, std::round(round));
  EXPECT_NEAR(round, std::round(2 * kPi * 0.05 / 0.05), 1e-6);
  // v is the way along the trunk in pictures.
  double top = 0;
  Surface alone = tube_surface(trunk(20), shape);
  for (const Vec2& uv : alone.uv) top = std::max<double>(top, uv.y);
  EXPECT_NEAR(top, (1 + 0.6 * 0.05) / (2 * kPi * 0.05 / round * 2), 1e-3) << "with its end";
}

TEST(Tubes, LobesWaveTheTrunkAlone) {
  Skeleton s = trunk(10);
  TubeShape shape;
  shape.lobes = 5;
  shape.lobe_depth = 0.2;
  float least = 1, most = 0;
  for (Vec3 p : tube_surface(s, shape).position) {
    if (p.y > 0.5f) continue;
    least = std::min(least, std::hypot(p.x, p.z));
    most = std::max(most, std::hypot(p.x, p.z));
  }
  EXPECT_NEAR(most, 0.06, 0.001);
  EXPECT_NEAR(least, 0.04, 0.001);
}

TEST(Tubes, AreCoarserWhereAGrainHidesIt) {
  Skeleton s;
  for (int i = 0; i <= 40; ++i)
    s.add(Vec3(0.2 * std::sin(i * 0.1), i * 0.1, 0), static_cast<float>(0.1 - i * 0.002), i - 1, 0);
  TubeShape shape;
  Surface whole = tube_surface(s, shape);
  shape.grain = 0.04;
  Surface less = tube_surface(s, shape);
  EXPECT_EQ(less.find_fault(), "");
  EXPECT_LT(less.triangle.size(), whole.triangle.size() / 4);
  EXPECT_NEAR(area(less), area(whole), 0.08 * area(whole));
  auto highest = [](const Surface& tube) {
    float v = 0;
    for (const Vec2& at : tube.uv) v = std::max(v, at.y);
    return v;
  };
  EXPECT_NEAR(highest(less), highest(whole), 1e-3) << "the picture goes as far along";
}

TEST(Tubes, ThinBranchesMayBeLeftOut) {
  Skeleton s = candelabrum(5, Seed{2});
  TubeShape shape;
  shape.least = 0.04f;
  std::vector<bool> out = left_out(s, shape);
  std::size_t gone = static_cast<std::size_t>(std::count(out.begin(), out.end(), true));
  EXPECT_GT(gone, 0u);
  EXPECT_LT(gone, s.size());
  Surface all = tube_surface(s, {}), some = tube_surface(s, shape);
  EXPECT_LT(some.position.size(), all.position.size());
  // What is thin now and will be thick stays.
  std::vector<float> girth(s.size(), 0.05f);
  shape.girth = girth;
  out = left_out(s, shape);
  EXPECT_EQ(std::count(out.begin(), out.end(), true), 0);
}

/// Internodes are much shorter than an old stem is thick.
TEST(Tubes, RingsOfAThickCrookedStemDoNotCross) {
  Skeleton s;
  Vec3 at(0);
  for (int i = 0; i < 40; ++i) {
    s.add(at, 0.5f, i - 1, 0);
    at += 0.1f * glm::normalize(Vec3(0.25f * std::sin(2.1f * static_cast<float>(i)), 1,
                                     0.25f * std::cos(3.7f * static_cast<float>(i))));
  }
  Surface tube = tube_surface(s, {.most_sides = 24});
  for (std::size_t i = 0; i + 25 < 40 * 25; ++i)
    ASSERT_GT(tube.position[i + 25].y, tube.position[i].y + 0.02f) << "each lies above the one below it";
}

TEST(Tubes, MoveWithAPose) {
  Skeleton s = candelabrum(5, Seed{2});
  // Turned as a whole, the tubes are turned.
  Quat turn = glm::angleAxis(0.7f, glm::normalize(Vec3(1, 0.2f, 0.4f)));
  std::vector<Vec3> position;
  for (Vec3 p : s.position) position.push_back(turn * p);
  std::vector<Quat> turns(s.size(), turn);
  Surface rest = tube_surface(s, {}), moved = tube_surface(s, position, s.radius, turns, {});
  ASSERT_EQ(moved.find_fault(), "");
  ASSERT_EQ(moved.position.size(), rest.position.size());
  EXPECT_EQ(moved.uv, rest.uv);  // the picture stays where it is on the skin
  for (std::size_t i = 0; i < rest.position.size(); ++i) {
    EXPECT_LT(glm::distance(turn * rest.position[i], moved.position[i]), 1e-4f);
    EXPECT_LT(glm::distance(turn * rest.normal[i], moved.normal[i]), 1e-3f);
  }
}

TubeMesh closed(const Skeleton& s, int sides = 12, float front = 2) {
  return closed_tubes(s, s.position, s.radius, front, sides);
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

TEST(ClosedTubes, AreClosedAndFaceOutward) {
  Skeleton s = candelabrum(5, Seed{3});
  TubeMesh mesh = closed(s);
  EXPECT_EQ(mesh.surface.find_fault(), "");
  EXPECT_EQ(mesh.node.size(), mesh.surface.position.size());
  auto [open, volume] = open_edges(mesh.surface);
  EXPECT_EQ(open, 0);
  EXPECT_GT(volume, 0);
}

TEST(ClosedTubes, HaveTheVolumeOfTheBranch) {
  Skeleton s = trunk(30, 2, 0.1f);
  auto [open, volume] = open_edges(closed(s, 48).surface);
  double exact = kPi * 0.01 * 2 + 2 * kPi / 3 * 0.001 + kPi / 3 * 0.01 * 0.05;  // a half ball, a cone below
  EXPECT_NEAR(volume, exact, 0.01 * exact);
}

TEST(ClosedTubes, AreSmoothAlongTheBranch) {
  // A spiral: rings must follow it without twisting round it.
  Skeleton s;
  for (int i = 0; i < 60; ++i) {
    float t = 0.2f * static_cast<float>(i);
    s.add({std::cos(t), 0.1f * t, std::sin(t)}, 0.05f, i - 1, 0);
  }
  Surface surface = closed(s, 16).surface;
  for (const auto& t : surface.triangle) {
    Vec3 face = glm::cross(surface.position[t[1]] - surface.position[t[0]],
                           surface.position[t[2]] - surface.position[t[0]]);
    if (glm::length(face) < 1e-9f) continue;
    for (std::uint32_t v : t) EXPECT_GT(glm::dot(glm::normalize(face), surface.normal[v]), 0.4f);
  }
}

TEST(ClosedTubes, StopWhereGrowthHasComeTo) {
  Skeleton s = trunk(20);
  TubeMesh half = closed(s, 8, 0.5f);
  for (std::int32_t node : half.node)
    EXPECT_LT(s.birth[static_cast<std::size_t>(s.parent[static_cast<std::size_t>(node)])], 0.5f);
  EXPECT_TRUE(closed(s, 8, 0).surface.triangle.empty());
}

}  // namespace
}  // namespace frond
