#include "rocks/framework.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "closed.h"
#include "core/parallel.h"
#include "rocks/rock.h"

namespace frond {
namespace {

constexpr double kSize = 1.7;  // metres, as in a reef
constexpr FrameworkCells kCells{1.0 / 128, 0.002};

/// Share of the area, without the foot, that faces downward more than a direction with that upward part.
double overhanging(const Surface& s, float upward = -0.1f) {
  double all = 0, over = 0;
  for (const auto& t : s.triangle) {
    Vec3 twice = area_of(s, t);
    float area = glm::length(twice);
    if (s.position[t[0]].y < 0.01 && twice.y < 0) continue;
    all += area;
    if (twice.y < upward * area) over += area;
  }
  return over / all;
}

/// How even the surface is within a radius of places that are evenly spread over it: the mean of the length
/// of the sum of area vectors there over the sum of their lengths, 1 where it is flat.
double evenness(const Surface& s, float radius) {
  constexpr float kApart = 0.02f;  // m2 to a place
  double sum = 0;
  int count = 0;
  float area = 0;
  for (const auto& t : s.triangle) {
    area += glm::length(area_of(s, t)) / 2;
    if (area < kApart) continue;
    area -= kApart, ++count;
    Vec3 all(0);
    float lengths = 0;
    for (const auto& u : s.triangle)
      if (glm::distance(s.position[u[0]], s.position[t[0]]) < radius)
        all += area_of(s, u), lengths += glm::length(area_of(s, u));
    sum += glm::length(all) / lengths;
  }
  return sum / count;
}

TEST(Framework, IsOneClosedPieceWithHolesThrough) {
  for (std::uint64_t i = 0; i < 6; ++i) {
    Surface reef = framework_surface({}, kSize, kCells, Seed{i});
    EXPECT_EQ(reef.find_fault(), "");
    EXPECT_EQ(count_pieces(reef), 1) << i;
    Body body = body_of(reef);
    EXPECT_EQ(body.loose, 0u) << i;
    EXPECT_GT(body.volume, 0.1);
    // 2 - 2 genus: an even number.
    EXPECT_EQ(body.euler % 2, 0);
    long genus = (2 - body.euler) / 2;
    EXPECT_GE(genus, 3) << i;
    EXPECT_LE(genus, 100) << i;
    Vec3 low = reef.position[0], high = low;
    for (Vec3 p : reef.position) low = glm::min(low, p), high = glm::max(high, p);
    EXPECT_NEAR(low.y, 0, 1e-6);
    EXPECT_NEAR(std::max(high.x - low.x, high.z - low.z), kSize, 1e-4);
    EXPECT_NEAR(high.y, 0.55 * kSize, 0.15 * kSize);
  }
}

TEST(Framework, HasOverhangsAndLedges) {
  Framework domes{.plates = 0}, plates{.plates = 0.7};
  for (std::uint64_t i = 0; i < 3; ++i) {
    double share = overhanging(framework_surface({}, kSize, kCells, Seed{i}));
    EXPECT_GT(share, 0.2) << i;
    EXPECT_LT(share, 0.5) << i;
    // The undersides of plates are nearly level.
    EXPECT_GT(overhanging(framework_surface(plates, kSize, kCells, Seed{i}), -0.9f),
              1.2 * overhanging(framework_surface(domes, kSize, kCells, Seed{i}), -0.9f))
        << i;
  }
}

TEST(Framework, IsHollowedByBoring) {
  Framework massive{.boring = 0}, bored{.boring = 1};
  for (std::uint64_t i = 0; i < 3; ++i) {
    Body before = body_of(framework_surface(massive, kSize, kCells, Seed{i}));
    Body after = body_of(framework_surface(bored, kSize, kCells, Seed{i}));
    EXPECT_LT(after.volume, 0.95 * before.volume) << i;
    EXPECT_LT(after.euler, before.euler) << i;  // more holes go through
  }
}

TEST(Framework, IsThereInCellsOfAnyTolerance) {
  Framework low{.height = 0.2, .colonies = 0};
  for (std::uint64_t i = 0; i < 20; ++i) {
    Surface reef = framework_surface(low, kSize, {1.0 / 128, 0.1}, Seed{i});
    ASSERT_FALSE(reef.triangle.empty()) << i;
    EXPECT_EQ(body_of(reef).loose, 0u) << i;
  }
}

TEST(Framework, HasNoSmoothPart) {
  constexpr float kPatch = 0.06f;  // metres
  RockShape boulder;
  boulder.size = kSize, boulder.cells = {7, 0.002};
  for (std::uint64_t i = 0; i < 3; ++i) {
    EXPECT_LT(evenness(framework_surface({}, kSize, kCells, Seed{i}), kPatch), 0.8) << i;
    EXPECT_GT(evenness(rock_surface(boulder, Seed{i}), kPatch), 0.9) << i;
  }
}

TEST(Framework, TakesFewTriangles) {
  for (double tolerance : {0.003, 0.0015}) {
    std::size_t blobs = 0, framework = 0;
    for (std::uint64_t i = 0; i < 6; ++i) {
      RockShape shape;
      shape.cells.tolerance = tolerance;
      blobs += rock_surface(shape, Seed{i}).triangle.size();
      shape.form = RockForm::framework;
      framework += rock_surface(shape, Seed{i}).triangle.size();
    }
    EXPECT_LT(framework, blobs * 8 / 5) << tolerance;
    EXPECT_GT(framework, blobs / 2) << tolerance;
  }
}

TEST(Framework, IsTheSameAtAnyNumberOfThreadsFromTheSameSeedOnly) {
  Surface many = framework_surface({}, kSize, kCells, Seed{1});
  limit_threads(1);
  Surface one = framework_surface({}, kSize, kCells, Seed{1});
  limit_threads(0);
  EXPECT_EQ(many.position, one.position);
  EXPECT_EQ(many.triangle, one.triangle);
  EXPECT_NE(many.position, framework_surface({}, kSize, kCells, Seed{2}).position);
}

TEST(Rubble, IsAClosedFragmentThatLies) {
  for (std::uint64_t i = 0; i < 8; ++i) {
    Surface stone = rubble_surface({}, 0.1, {1.0 / 32, 0.004}, Seed{i});
    EXPECT_EQ(stone.find_fault(), "");
    Body body = body_of(stone);
    EXPECT_EQ(body.loose, 0u);
    Vec3 low = stone.position[0], high = low;
    for (Vec3 p : stone.position) low = glm::min(low, p), high = glm::max(high, p);
    EXPECT_NEAR(high.x - low.x, 0.1, 0.03);
    EXPECT_NEAR(low.y, 0, 1e-6);
    EXPECT_LT(high.y, 0.07);
    // Branches fill little of the ball round them.
    EXPECT_LT(body.volume, 0.35 * 4.19 * 0.05 * 0.05 * 0.05) << i;
  }
}

}  // namespace
}  // namespace frond
