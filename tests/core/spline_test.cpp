#include "core/spline.h"

#include <gtest/gtest.h>

#include "core/seed.h"

namespace frond {
namespace {

using Point = SplinePoint<glm::dvec2>;
using Line = std::vector<glm::dvec2>;

Line places(const std::vector<Point>& points, const SplineShape& shape) {
  return spline_places(std::span<const Point>(points), shape);
}

std::vector<Point> random_points(std::size_t count, bool handles, Seed seed) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    Seed own = seed.child(i);
    auto vector = [&](std::uint64_t k) {
      return glm::dvec2(own.child(k).range(-1, 1), own.child(k + 10).range(-1, 1));
    };
    points.push_back(glm::dvec2(i, 0) + vector(0));
    if (handles && own.child(5).unit() < 0.6) points.back().out = vector(1);
    if (handles && own.child(6).unit() < 0.4) points.back().in = vector(2);
  }
  return points;
}

TEST(Spline, LeadsThroughItsPointsWhateverItsHandles) {
  for (std::uint64_t s = 0; s < 40; ++s)
    for (bool smooth : {false, true})
      for (bool closed : {false, true}) {
        std::vector<Point> points = random_points(3 + s % 5, s % 2, Seed{s});
        Line line = places(points, {smooth, closed});
        for (const Point& p : points) EXPECT_TRUE(std::ranges::find(line, p.at) != line.end());
        EXPECT_EQ(line.front(), points.front().at);
        if (!closed) {
          EXPECT_EQ(line.back(), points.back().at);
        }
      }
}

TEST(Spline, IsStraightBetweenCorners) {
  std::vector<Point> points = random_points(6, false, Seed{1});
  EXPECT_EQ(places(points, {}), spline_points(points));
  points[3].out = glm::dvec2(0.2, 0);
  EXPECT_EQ(places(points, {}).size(), 6u + 2 * 11u) << "only the two spans beside it bend";
}

TEST(Spline, LeavesAPointAlongItsHandleAndComesFromTheOppositeOne) {
  std::vector<Point> points = random_points(3, false, Seed{2});
  points[1].out = glm::dvec2(0.3, 0.4);
  Line line = places(points, {.smooth = true, .pieces = 1000});
  glm::dvec2 after = line[1001] - line[1000], before = line[1000] - line[999];
  EXPECT_NEAR(glm::dot(glm::normalize(after), glm::dvec2(0.6, 0.8)), 1, 1e-4);
  EXPECT_NEAR(glm::dot(glm::normalize(before), glm::dvec2(0.6, 0.8)), 1, 1e-4);
}

TEST(Spline, SmoothHasNoCornerAndLinesAreKept) {
  std::vector<Point> straight{glm::dvec2(0, 0), glm::dvec2(1, 2), glm::dvec2(2, 4), glm::dvec2(3, 6)};
  for (glm::dvec2 p : places(straight, {.smooth = true})) EXPECT_NEAR(p.y, 2 * p.x, 1e-12);
  for (bool closed : {false, true}) {
    std::vector<Point> points = random_points(6, false, Seed{3});
    Line line = places(points, {.smooth = true, .closed = closed, .pieces = 2000});
    std::size_t n = line.size();
    for (std::size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < n; ++i) {
      glm::dvec2 way = line[(i + 1) % n] - line[i], from = line[i] - line[(i + n - 1) % n];
      EXPECT_GT(glm::dot(glm::normalize(way), glm::normalize(from)), 0.99) << i;
    }
  }
}

}  // namespace
}  // namespace frond
