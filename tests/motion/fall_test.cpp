#include "motion/fall.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/posed.h"

namespace frond {
namespace {

/// A stem of 12 m and 400 kg.
Overturning stem() {
  Overturning body;
  body.inertia = 400 * 12 * 12 / 3.0;
  body.weight = 400 * 9.81 * 6;
  body.balance = 0.1;
  body.excess = 900;
  body.torn = 0.3;
  return body;
}

/// The work of all moments up to an angle, J.
double work(const Overturning& b, double angle) {
  double roots = b.excess + b.weight * std::sin(b.balance), torn = std::min(angle, b.torn);
  return b.weight * (std::cos(b.balance) - std::cos(angle - b.balance)) +
         roots * (torn - torn * torn / (2 * b.torn));
}

std::size_t impact(const std::vector<float>& course, const Overturning& body) {
  std::size_t k = 0;
  while (k < course.size() && course[k] < static_cast<float>(body.stop)) ++k;
  return k;
}

TEST(FallCourse, AgreesWithStepsSoSmallThatTheirOrderDoesNotMatter) {
  Overturning b = stem();
  std::vector<float> course = course_of(b);
  double angle = 0, speed = 0, roots = b.excess + b.weight * std::sin(b.balance);
  constexpr int kFiner = 200;
  for (std::size_t k = 0; k < impact(course, b); ++k) {
    EXPECT_NEAR(course[k], angle, 0.01 * angle + 1e-6) << k;
    for (int i = 0; i < kFiner; ++i) {
      double left = angle < b.torn ? 1 - angle / b.torn : 0;
      speed += (b.weight * std::sin(angle - b.balance) + roots * left) / b.inertia * kFallStep / kFiner;
      angle += speed * kFallStep / kFiner;
    }
  }
}

TEST(FallCourse, IsMonotonicUpToTheGroundAndGainsNoEnergy) {
  Overturning b = stem();
  std::vector<float> course = course_of(b);
  std::size_t hit = impact(course, b);
  ASSERT_LT(hit, course.size());
  for (std::size_t k = 1; k < course.size(); ++k) {
    double speed = static_cast<double>(course[k] - course[k - 1]) / kFallStep;
    if (k <= hit) {
      EXPECT_GT(course[k], course[k - 1]);
    }
    EXPECT_LE(b.inertia * speed * speed / 2, work(b, std::max(course[k], course[k - 1])) * 1.001);
    EXPECT_LE(course[k], static_cast<float>(b.stop));
    EXPECT_GT(course[k], k < hit ? 0 : 0.9 * b.stop) << "it settles within a few degrees";
  }
  EXPECT_EQ(course.back(), static_cast<float>(b.stop));
}

TEST(FallCourse, RestsAtALeanWhereTheRootsBringItThere) {
  Overturning b = stem();
  b.balance = 0.5, b.torn = 0.3;
  std::vector<float> course = course_of(b);
  EXPECT_GT(course.back(), 0);
  EXPECT_LT(course.back(), 0.5f);
}

/// A stem of ten metres that leans a bit, with limbs on all sides, and a root.
Skeleton limbed() {
  Skeleton s;
  std::int32_t below = s.add(Vec3(1, 0, 2), 0.15f, Skeleton::kRoot, 0);
  std::vector<std::int32_t> stem{below};
  for (float i = 1; i <= 20; ++i)
    stem.push_back(below = s.add(Vec3(1, 0.5f * i, 2 + 0.01f * i), 0.15f - 0.006f * i, below, 0));
  for (int k = 4; k < 20; ++k) {
    float turn = 2.4f * static_cast<float>(k);
    Vec3 out(std::cos(turn), 0.6f, std::sin(turn));
    below = stem[static_cast<std::size_t>(k)];
    for (int i = 0; i < 8; ++i) below = s.add(s.position[below] + 0.2f * out, 0.02f, below, 1);
  }
  s.add(Vec3(1.4f, -0.3f, 2), 0.03f, 0, 1);
  set_tip_distances(s);
  return s;
}

/// Of any direction, over ground that falls or rises.
struct Case {
  Vec3 axis;
  double slope;
};

TEST(FallPose, KeepsLengthsStaysAboveTheGroundAndDoesNotJump) {
  Skeleton rest = limbed();
  for (Case c : {Case{Vec3(0, 0, -1), 0}, Case{Vec3(0, 0, 1), 0.3}, Case{Vec3(0.6f, 0, 0.8f), -0.3}}) {
    GroundHeight ground = [&](double x, double z) { return c.slope * (x - 1) + 0.05 * std::sin(z - 2); };
    Fall fall{2, Vec3(1, 0, 2) + 0.6f * glm::cross(c.axis, Vec3(0, 1, 0)), c.axis, {}};
    Overturning body = stem();
    body.stop = 1.5 - c.slope * static_cast<double>(glm::cross(c.axis, Vec3(0, 1, 0)).x);
    fall.course = course_of(body);
    const Pose upright = posed(rest, {}, 0);
    Pose before = upright;
    for (double time = 0; time < fall.start + fall.length() + 0.2; time += 1.0 / 60) {
      Pose now = upright;
      turn_fallen(fall, rest, time, ground, now);
      for (std::size_t i = 1; i < rest.size(); ++i) {
        auto p = static_cast<std::size_t>(rest.parent[i]);
        float length = glm::distance(rest.position[i], rest.position[p]);
        EXPECT_NEAR(glm::distance(now.position[i], now.position[p]), length, 1e-4f);
        Vec3 at = now.position[i];
        if (rest.position[i].y > 0) {
          EXPECT_GT(at.y, ground(at.x, at.z) - 0.03) << i;
        }
        EXPECT_LT(glm::distance(at, before.position[i]) * 60, std::sqrt(3 * 9.81 * 12)) << i << " " << time;
      }
      before = now;
    }
  }
}

TEST(FallPose, BeforeItsTimeNothingTurns) {
  Skeleton rest = limbed();
  Fall fall{2, Vec3(1.6f, 0, 2), Vec3(0, 0, -1), course_of(stem())};
  Pose now = posed(rest, {}, 0);
  turn_fallen(
      fall, rest, 2, [](double, double) { return 0; }, now);
  EXPECT_EQ(now.position, rest.position);
  EXPECT_EQ(fall.sway(2), 1);
  EXPECT_EQ(fall.sway(2 + fall.length()), 0);
}

}  // namespace
}  // namespace frond
