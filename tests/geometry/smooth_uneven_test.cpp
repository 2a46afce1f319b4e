#include <gtest/gtest.h>

#include <cmath>

#include "core/spline.h"
#include "geometry/smooth.h"

// Smooth lines whose points lie close together here and far apart there.

namespace frond {
namespace {

Skeleton line_of(const std::vector<Vec3>& points) {
  Skeleton skeleton;
  for (std::size_t i = 0; i < points.size(); ++i)
    skeleton.add(points[i], 0.2f, static_cast<std::int32_t>(i) - 1, 0);
  return skeleton;
}

/// Forty nodes close together between pieces of 2 and 3 m, straight up.
Skeleton cane() {
  std::vector<Vec3> points{{0, 0, 0}, {0, 2, 0}};
  for (int i = 1; i <= 40; ++i) points.emplace_back(0, 2 + 0.025f * static_cast<float>(i), 0);
  points.emplace_back(0, 6, 0);
  return line_of(points);
}

TEST(SmoothUneven, CloseNodesBetweenLongPiecesMakeNoKnobAndNoFold) {
  for (int pieces : {1, 2, 3, 5, 8}) {
    Skeleton fine = smooth(cane(), pieces);
    for (std::size_t i = 1; i < fine.size(); ++i)
      EXPECT_GT(fine.position[i].y, fine.position[i - 1].y) << pieces << " pieces, node " << i;
    EXPECT_EQ(fine.position.back(), Vec3(0, 6, 0));
  }
}

/// How far a place lies from a polyline.
float distance_to(const Skeleton& line, Vec3 at) {
  float least = 1e9f;
  for (std::size_t i = 1; i < line.size(); ++i) {
    Vec3 a = line.position[i - 1], way = line.position[i] - a;
    float t = std::clamp(glm::dot(at - a, way) / glm::dot(way, way), 0.0f, 1.0f);
    least = std::min(least, glm::distance(at, a + way * t));
  }
  return least;
}

TEST(SmoothUneven, StaysInTheTubeOfThePolylineAtPiecesOfATenthOfAMillimetre) {
  Skeleton kink = line_of({{0, 0, 0},
                           {0, 1, 0},
                           {0.01f, 0.4f, 0},
                           {0.0104f, 0.4f, 0},
                           {0.0104f, 0.42f, 0.9f},
                           {0.0105f, 0.42f, 0.9f},
                           {0.9f, 0.42f, 0.9f}});
  for (int pieces : {2, 3, 8}) {
    Skeleton fine = smooth(kink, pieces);
    for (std::size_t i = 0; i < fine.size(); ++i)
      EXPECT_LT(distance_to(kink, fine.position[i]), 0.03f) << pieces << " pieces, node " << i;
  }
}

TEST(SmoothUneven, EvenPointsKeepTheCurveThatTheyHad) {
  Vec3 before(0, 0, 0), at(0.3f, 1, 0.1f), after(0.2f, 2.1f, 0.4f);
  SplineSlopes<Vec3> slopes = spline_slopes(before, at, after);
  EXPECT_EQ(slopes.in, (after - before) * 0.5f);
  EXPECT_EQ(slopes.out, (after - before) * 0.5f);
}

TEST(SmoothUneven, SlopesPassFromTheOneCurveToTheOtherWithoutAJump) {
  Vec3 last(0);
  for (float length = 0.2f; length < 6; length *= 1.002f) {
    SplineSlopes<Vec3> slopes = spline_slopes(Vec3(0, -1, 0), Vec3(0), Vec3(length, 0.2f, 0));
    if (length > 0.2f) {
      EXPECT_LT(glm::distance(slopes.out, last), 0.02f * (1 + length)) << length;
    }
    last = slopes.out;
  }
}

TEST(SmoothUneven, LinesThroughPointsDoNotRunPastThem) {
  std::vector<SplinePoint<Vec3>> points;
  for (float y : {0.0f, 2.0f, 2.025f, 2.05f, 5.0f}) points.emplace_back(Vec3(0, y, 0));
  SplineShape shape;
  shape.smooth = true;
  std::vector<Vec3> places = spline_places<Vec3>(points, shape);
  for (std::size_t i = 1; i < places.size(); ++i) EXPECT_GE(places[i].y, places[i - 1].y) << i;
}

}  // namespace
}  // namespace frond
