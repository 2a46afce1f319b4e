#include "rocks/blobs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rocks/falloffs.h"

namespace frond {
namespace {

DVec3 point(Seed seed, double reach) {
  return {seed.child(0).range(-reach, reach), seed.child(1).range(-reach, reach),
          seed.child(2).range(-reach, reach)};
}

Blobs random_rock(std::uint64_t number, Falloff falloff) {
  return {random_blobs({}, Seed{number}), falloff, 1};
}

TEST(Blobs, HaveTheFieldsThatAreGiven) {
  Blob blob{{0.5, 1, 2}, {0.4, -0.3, 0.1}};
  DVec3 p(0.7, 0.2, -0.9);
  double d2 = 0;
  d2 += std::pow(0.7 / 0.5 - 0.4, 2);
  d2 += std::pow(0.2 / 1 + 0.3, 2);
  d2 += std::pow(-0.9 / 2 - 0.1, 2);
  double r = 2, t = d2 / (r * r);
  EXPECT_NEAR(field_value({{blob}, Falloff::gaussian, 1}, p), std::exp(-r * d2) - 1, 1e-14);
  EXPECT_NEAR(field_value({{blob}, Falloff::soft, 1}, p),
              -4 * std::pow(d2, 3) / (9 * std::pow(r, 6)) + 17 * d2 * d2 / (9 * std::pow(r, 4)) -
                  22 * d2 / (9 * r * r),
              1e-14);
  EXPECT_NEAR(field_value({{blob}, Falloff::cubic, 1}, p), std::pow(1 - t, 3) - 1, 1e-14);
  // Beyond r the last two end, and fields add up.
  EXPECT_EQ(field_value({{blob, blob}, Falloff::soft, 1}, {9, 9, 9}), -1);
  EXPECT_EQ(field_value({{blob, blob}, Falloff::cubic, 1}, {9, 9, 9}), -1);
  EXPECT_NEAR(field_value({{blob, blob}, Falloff::gaussian, 1}, p), 2 * std::exp(-r * d2) - 1, 1e-14);
}

TEST(Blobs, GradientAndCurvatureAreThoseOfTheField) {
  for (Falloff falloff : kFalloffs)
    for (std::uint64_t i = 0; i < 40; ++i) {
      Blobs shape = random_rock(i, falloff);
      DVec3 p = point(Seed{i}.child("p"), 1.2), gradient = field_gradient(shape, p);
      double h = 1e-5;
      for (int axis = 0; axis < 3; ++axis) {
        DVec3 step(0);
        step[axis] = h;
        double slope = (field_value(shape, p + step) - field_value(shape, p - step)) / (2 * h);
        EXPECT_NEAR(gradient[axis], slope, 1e-6 * (1 + std::abs(slope)));
      }
      // Along the surface its direction turns by the curvature a unit at most.
      DVec3 n = glm::normalize(gradient), along = glm::normalize(glm::cross(n, point(Seed{i}.child("a"), 1)));
      DVec3 next = glm::normalize(field_gradient(shape, p + along * h));
      double turn = glm::length(next - n - glm::dot(next - n, n) * n) / h;
      EXPECT_LE(turn, field_curvature(shape, p) * 1.001 + 1e-3);
    }
  Blobs ball{{{DVec3(1), DVec3(0)}}, Falloff::gaussian, 0.5};
  EXPECT_NEAR(field_curvature(ball, {0.4, 0, 0}), std::sqrt(2) / 0.4, 1e-9);
}

TEST(Blobs, RangesHoldAllValuesOfABox) {
  double slack = 0;
  for (Falloff falloff : kFalloffs)
    for (std::uint64_t i = 0; i < 60; ++i) {
      Blobs shape = random_rock(i, falloff);
      Seed seed = Seed{i}.child("box");
      DVec3 corner = point(seed.child("corner"), 2.5), half = glm::abs(point(seed.child("half"), 0.4));
      Box box{corner - half, corner + half};
      DVec3 direction = glm::normalize(point(seed.child("direction"), 1));
      Interval value = field_range(shape, box), slope = field_slope_range(shape, box, direction),
               seen{1e9, -1e9};
      for (std::uint64_t k = 0; k < 200; ++k) {
        DVec3 p = box.middle() + half * point(seed.child("p", k), 1);
        double f = field_value(shape, p);
        seen = {std::min(seen.low, f), std::max(seen.high, f)};
        EXPECT_TRUE(value.holds(f));
        EXPECT_TRUE(slope.holds(glm::dot(field_gradient(shape, p), direction)));
      }
      for (DVec3 end : {box.low, box.high}) EXPECT_TRUE(value.holds(field_value(shape, end)));
      slack += (value.high - value.low) - (seen.high - seen.low);
    }
  EXPECT_LT(slack / 180, 0.8);  // and not much more
}

TEST(Blobs, BoundsHoldTheSurfaceAndAreTight) {
  for (Falloff falloff : kFalloffs)
    for (std::uint64_t i = 0; i < 20; ++i) {
      Blobs shape = random_rock(i, falloff);
      Box box = field_bounds(shape);
      DVec3 middle = box.middle(), half = box.size() * 0.5;
      Box seen{DVec3(1e9), DVec3(-1e9)};
      for (std::uint64_t k = 0; k < 4000; ++k) {
        DVec3 p = middle + half * point(Seed{i}.child("p", k), 1.5);
        if (field_value(shape, p) <= 0) continue;
        seen.low = glm::min(seen.low, p), seen.high = glm::max(seen.high, p);
      }
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(seen.low[axis], box.low[axis]);
        EXPECT_LE(seen.high[axis], box.high[axis]);
        EXPECT_GT(seen.high[axis] - seen.low[axis], 0.6 * box.size()[axis]);
      }
    }
  EXPECT_EQ(field_bounds({}).size(), DVec3(0));
  EXPECT_EQ(field_bounds({{{DVec3(1), DVec3(0)}}, Falloff::cubic, 1}).size(), DVec3(0));
}

TEST(Blobs, RandomOnesStayInTheLargestBox) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    std::vector<Blob> blobs = random_blobs({6, 0.5, 2}, Seed{i});
    EXPECT_EQ(blobs.size(), 6u);
    DVec3 box(0), farthest(0);
    for (const Blob& b : blobs) box = glm::max(box, b.radius);
    for (const Blob& b : blobs)
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(b.radius[axis], 0.5);
        EXPECT_LT(b.radius[axis], 2);
        farthest[axis] = std::max(farthest[axis], b.radius[axis] * (1 + std::abs(b.center[axis])));
        EXPECT_LE(farthest[axis], box[axis] * (1 + 1e-12));
      }
  }
}

}  // namespace
}  // namespace frond
