#include "land/stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frond {
namespace {

constexpr double kSide = 80;

/// A hollow whose rim is lowest toward +x, in land that falls beyond it.
double hollow(Vec2 at) {
  double far = glm::length(at), toward = at.x / std::max(far, 1e-6);
  double rim = 3.5 - 2 * std::max(toward, 0.0);
  return far < 20 ? rim * (far / 20) * (far / 20) : rim - 0.05 * (far - 20);
}

double slope(Vec2 at) { return 0.08 * at.y + 0.6 * std::sin(at.x / 7); }

TEST(Stream, RunsDownToTheRim) {
  StreamCourse stream({.from = {3, 30}, .width = 1.5}, kSide, slope, Seed{4});
  ASSERT_TRUE(stream.flows());
  const auto& course = stream.course();
  for (std::size_t i = 1; i < course.size(); ++i) {
    EXPECT_LT(course[i].level, course[i - 1].level);
    EXPECT_LT(glm::distance(course[i].at, course[i - 1].at), 0.7f);
  }
  EXPECT_LT(course.back().at.y, -kSide / 2 + 3);
  EXPECT_LT(glm::distance(course.front().at, Vec2(3, 30)), 3);
}

TEST(Stream, LeavesHollowsOverTheLowestSaddle) {
  StreamCourse stream({.from = {-6, 2}, .width = 1}, kSide, hollow, Seed{4});
  ASSERT_TRUE(stream.flows());
  float nearest = 1e9f;
  for (const StreamPoint& p : stream.course()) nearest = std::min(nearest, glm::distance(p.at, Vec2(20, 0)));
  EXPECT_LT(nearest, 4);
}

TEST(Stream, CutsABedWithoutSteps) {
  StreamCourse stream({.from = {3, 30}, .width = 1.5, .depth = 0.4}, kSide, slope, Seed{4});
  const StreamPoint& middle = stream.course()[stream.course().size() / 2];
  EXPECT_NEAR(stream.height(middle.at, slope(middle.at)), middle.level - 0.4, 0.15);
  Vec2 across(-middle.toward.y, middle.toward.x);
  double last = 0;
  for (int i = 0; i <= 400; ++i) {
    Vec2 at = middle.at + 0.05f * static_cast<float>(i - 200) * across;
    double height = stream.height(at, slope(at));
    if (i == 0) last = height;
    EXPECT_LT(std::abs(height - last), 0.12) << i;
    EXPECT_TRUE(stream.distance(at) < 0.3 || height > middle.level - 0.15) << i;
    last = height;
  }
  EXPECT_EQ(stream.height({-30, 30}, 7), 7);
  EXPECT_TRUE(stream.bed().find_fault().empty()) << stream.bed().find_fault();
  EXPECT_TRUE(stream.water().find_fault().empty()) << stream.water().find_fault();
  for (const Vec3& n : stream.water().normal) EXPECT_GT(n.y, 0.9f);
  EXPECT_FALSE(StreamCourse({.width = 0}, kSide, slope, Seed{1}).flows());
}

TEST(Stream, IsAsFastAsManningSays) {
  auto steep = [](Vec2 at) { return 0.16 * at.y; };
  auto flat = [](Vec2 at) { return 0.04 * at.y; };
  StreamShape shape{.from = {0, 30}, .width = 1.2, .depth = 0.15};
  double fast = StreamCourse(shape, kSide, steep, Seed{1}).speed(),
         slow = StreamCourse(shape, kSide, flat, Seed{1}).speed();
  EXPECT_NEAR(fast / slow, 2, 0.25);
  EXPECT_NEAR(slow, std::pow(0.1, 2.0 / 3) * 0.2 / 0.06, 0.15);
}

TEST(Stream, LeavesDriftOnIt) {
  StreamCourse stream({.from = {3, 30}, .width = 1.5, .leaves = 40}, kSide, slope, Seed{4});
  auto now = stream.leaves(2, 0), then = stream.leaves(2.1, 0);
  ASSERT_EQ(now.size(), 40U);
  double gone = 0;
  for (std::size_t k = 0; k < now.size(); ++k) {
    EXPECT_LT(stream.distance({now[k].at.x, now[k].at.z}), 0.05);
    double way = glm::distance(now[k].at, then[k].at);
    if (way < 1) gone += way;  // else it has begun anew
  }
  EXPECT_NEAR(gone / 40, 0.1 * stream.speed(), 0.03 * stream.speed());
  auto begin = stream.leaves(0, 5), end = stream.leaves(5, 5);
  for (const Afloat& a : begin)
    EXPECT_TRUE(std::ranges::any_of(end, [&](const Afloat& b) {
      return glm::distance(a.at, b.at) < 1e-2f && a.kind == b.kind && std::abs(a.size - b.size) < 1e-3f;
    }));
}

}  // namespace
}  // namespace frond
