#include "motion/motion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "motion/posed.h"
#include "shapes.h"

namespace frond {
namespace {

TEST(Pose, WithoutMotionIsTheRestShape) {
  Skeleton s = candelabrum(7, Seed{1});
  Pose pose = posed(s, Motion{}, 1);
  for (std::size_t i = 0; i < s.size(); ++i) {
    EXPECT_LT(glm::distance(pose.position[i], s.position[i]), 1e-5f);
    EXPECT_FLOAT_EQ(pose.radius[i], s.radius[i]);
  }
}

TEST(Pose, KeepsLengthsAndTheFootPlanted) {
  Skeleton s = candelabrum(12, Seed{2});
  Motion motion = lively();
  motion.growth = {};
  for (double time : {0.0, 0.7, 1.9, 3.3}) {
    Pose pose = posed(s, motion, time);
    EXPECT_EQ(pose.position[0], s.position[0]);
    for (std::size_t i = 1; i < s.size(); ++i) {
      float rest = glm::distance(s.position[i], s.position[s.parent[i]]);
      EXPECT_NEAR(glm::distance(pose.position[i], pose.position[s.parent[i]]), rest, 1e-5f) << "node " << i;
    }
  }
}

TEST(Pose, BendsRatherThanShears) {
  // However strong the pull, a branch turns little from one segment to the next.
  Skeleton s = trunk(40);
  Motion motion;
  motion.food.strength = 3;
  motion.food.position = Vec3(2, 0.2f, 0);
  Pose pose = posed(s, motion, 0);
  for (std::size_t i = 2; i < s.size(); ++i) {
    Vec3 a = glm::normalize(pose.position[i - 1] - pose.position[i - 2]);
    Vec3 b = glm::normalize(pose.position[i] - pose.position[i - 1]);
    EXPECT_GT(glm::dot(a, b), std::cos(radians(7.0f)));
  }
}

TEST(Food, IsReachedForMoreTheStrongerAndTheMoreGrown) {
  Skeleton s = trunk(30);
  Vec3 food(1.5f, 1, 0);
  auto distance = [&](double strength, double time) {
    Motion motion;
    motion.growth = {0, 2, 0, 0.3};
    motion.food.strength = strength;
    motion.food.position = food;
    return glm::distance(posed(s, motion, time).position.back(), food);
  };
  EXPECT_LT(distance(0.5, 2), distance(0, 2) - 0.05f);
  EXPECT_LT(distance(1.5, 2), distance(0.5, 2) - 0.05f);

  // The bend of the part that is grown grows too.
  auto lean = [&](double time) {
    Motion motion;
    motion.growth = {0, 2, 0, 0.3};
    motion.food.strength = 1;
    motion.food.position = food;
    return posed(s, motion, time).position[10].x;
  };
  EXPECT_GT(lean(2), lean(0.7) + 1e-4f);
}

TEST(Food, IsFollowed) {
  Skeleton s = trunk(30);
  Motion motion = lively();
  motion.growth = {};
  motion.wave.amplitude = 0;
  EXPECT_GT(posed(s, motion, 0).position.back().x, 0.1f);
  EXPECT_GT(posed(s, motion, 2).position.back().z, 0.1f);
  EXPECT_LT(posed(s, motion, 4).position.back().x, -0.1f);
}

TEST(Food, PassesBehindWithoutAJump) {
  // Straight below and behind a branch there is no way to turn: the pull fades there.
  Skeleton s = trunk(60);
  Motion motion;
  motion.film_length = 4;
  motion.food.strength = 3;
  motion.food.position = Animated<Vec3>(
      std::vector<Animated<Vec3>::Key>{{0, Vec3(2, -0.5f, 0.01f)}, {4, Vec3(-2, -0.5f, 0.01f)}});
  double total = 0;
  float most = 0;
  Pose last = posed(s, motion, 0);
  for (int frame = 1; frame < 96; ++frame) {
    Pose now = posed(s, motion, frame / 24.0);
    float step = glm::distance(now.position.back(), last.position.back());
    most = std::max(most, step);
    total += step;
    last = now;
  }
  EXPECT_LT(most, 5 * total / 95);
}

/// A motion that stretches toward food alone.
Motion stretching(double stretch, Animated<Vec3> food) {
  Motion motion;
  motion.film_length = 4;
  motion.food.stretch = stretch;
  motion.food.position = std::move(food);
  return motion;
}

TEST(Food, StretchesSegmentsTowardItAndKeepsTheirVolumes) {
  Skeleton s = candelabrum(7, Seed{2});
  Pose pose = posed(s, stretching(1.5, Vec3(0.6f, 1.4f, 0.2f)), 0);
  bool longer = false;
  for (std::size_t i = 1; i < s.size(); ++i) {
    float rest = glm::distance(s.position[i], s.position[s.parent[i]]);
    float length = glm::distance(pose.position[i], pose.position[s.parent[i]]);
    EXPECT_NEAR(length, rest * pose.stretch[i], 1e-5f) << "node " << i;
    EXPECT_NEAR(pose.radius[i] * pose.radius[i] * length, s.radius[i] * s.radius[i] * rest, 1e-6f);
    EXPECT_GT(length, rest * 0.999f);
    EXPECT_LT(length, rest * 2.5f);
    longer = longer || length > 1.3f * rest;
    // The turn leads the segment of the rest shape to where it is.
    Vec3 led = pose.turn[i] * (s.position[i] - s.position[s.parent[i]]) * pose.stretch[i];
    EXPECT_LT(glm::distance(pose.position[i] - pose.position[s.parent[i]], led), 1e-4f);
  }
  EXPECT_TRUE(longer);
}

TEST(Food, StretchesMoreTheNearerATipAndTheFood) {
  Skeleton s = trunk(30);
  Pose near = posed(s, stretching(1, Vec3(0, 1.8f, 0)), 0), far = posed(s, stretching(1, Vec3(0, 6, 0)), 0),
       behind = posed(s, stretching(1, Vec3(0, -1, 0)), 0);
  for (std::size_t i = 2; i < s.size(); ++i) {
    EXPECT_GT(near.stretch[i], near.stretch[i - 1]);
    EXPECT_GT(near.stretch[i], far.stretch[i]);
    EXPECT_EQ(behind.stretch[i], 1);
  }
  EXPECT_GT(near.position.back().y, 1.15f);
  EXPECT_LT(near.position.back().y, 1.8f) << "it does not grow past the food";
}

TEST(Food, StretchesWithoutAJumpAndBackWhenItIsEaten) {
  Skeleton s = candelabrum(7, Seed{2});
  Motion motion = stretching(1.5, Animated<Vec3>({{0, Vec3(2, 0.5f, 0.01f)}, {4, Vec3(-2, 1.5f, 0.01f)}}));
  motion.food.reached = {2.5};
  double total = 0;
  float most = 0;
  Pose last = posed(s, motion, 0);
  for (int frame = 1; frame <= 96; ++frame) {
    Pose now = posed(s, motion, frame / 24.0);
    float step = 0;
    for (std::size_t i = 0; i < s.size(); ++i)
      step = std::max(step, glm::distance(now.position[i], last.position[i]));
    most = std::max(most, step), total += step;
    last = now;
  }
  EXPECT_LT(most, 5 * total / 96);
  EXPECT_LT(glm::distance(last.position.back(), s.position.back()), 1e-5f);
}

TEST(Wave, OfNoSpeedStandsStill) {
  Skeleton s = trunk(10);
  Motion motion;
  motion.film_length = 4;
  motion.wave.amplitude = 0.3;
  motion.wave.speed = 0;
  EXPECT_EQ(posed(s, motion, 0).position, posed(s, motion, 1.3).position);
}

TEST(Pose, KeepsNoSphereInsideItsNeighbour) {
  Skeleton s = trunk(10);
  s.radius[3] = 0.9f;
  Pose pose = posed(s, Motion{}, 0);
  for (std::size_t i = 1; i < s.size(); ++i)
    EXPECT_LT(std::abs(pose.radius[i] - pose.radius[i - 1]),
              glm::distance(pose.position[i], pose.position[i - 1]));
}

TEST(Wave, LoopsOverTheFilmAndGrowsTowardTheTips) {
  Skeleton s = trunk(30);
  Motion motion;
  motion.film_length = 3.7;
  motion.wave.amplitude = radians(15.0);
  Pose start = posed(s, motion, 0), end = posed(s, motion, 3.7), middle = posed(s, motion, 1.1);
  for (std::size_t i = 0; i < s.size(); ++i)
    EXPECT_LT(glm::distance(start.position[i], end.position[i]), 1e-4f);
  auto moved = [&](std::size_t i) { return glm::distance(start.position[i], middle.position[i]); };
  EXPECT_GT(moved(29), moved(20));
  EXPECT_GT(moved(20), moved(10));
  EXPECT_GT(moved(29), 0.02f);
}

TEST(Wave, DiffersWithItsPhase) {
  Skeleton s = trunk(30);
  Motion a, b;
  a.wave.amplitude = b.wave.amplitude = radians(15.0);
  b.wave.phase = 2;
  EXPECT_GT(glm::distance(posed(s, a, 0).position.back(), posed(s, b, 0).position.back()), 0.02f);
}

TEST(Growth, ComesFromNothingAndEndsWhole) {
  Skeleton s = candelabrum(9, Seed{3});
  Motion motion;
  motion.growth = {1, 2, 0, 0.3};
  Pose before = posed(s, motion, 0.5);
  for (std::size_t i = 0; i < s.size(); ++i) {
    EXPECT_EQ(before.position[i], s.position[0]);
    EXPECT_EQ(before.radius[i], 0);
  }
  Pose after = posed(s, motion, 3);
  for (std::size_t i = 0; i < s.size(); ++i) {
    EXPECT_LT(glm::distance(after.position[i], s.position[i]), 1e-5f);
    EXPECT_NEAR(after.radius[i], s.radius[i], 1e-6f);
  }
}

TEST(Growth, NeverShrinksNorStops) {
  Skeleton s = candelabrum(9, Seed{4});
  Motion motion;
  motion.growth = {0, 2, 0, 0.3};
  Pose last = posed(s, motion, 0);
  for (double time = 0.05; time <= 2; time += 0.05) {
    Pose now = posed(s, motion, time);
    EXPECT_GT(now.front, last.front);
    for (std::size_t i = 0; i < s.size(); ++i) {
      if (s.birth[i] > last.front) continue;
      EXPECT_GE(now.radius[i], last.radius[i] - 1e-7f);
    }
    last = now;
  }
}

TEST(Growth, IsEasedFromNothingToAll) {
  for (std::optional<Ease> ease : {std::optional<Ease>(), std::optional(Ease::none), std::optional(Ease::in),
                                   std::optional(Ease::out), std::optional(Ease::both)}) {
    Growth growth{.start = 1, .duration = 4, .ease = ease};
    double before = 0, all = 1 + growth.ripen;
    for (int i = 0; i <= 100; ++i) {
      double now = growth_front(growth, 1 + i / 25.0);
      EXPECT_GE(now, before);
      EXPECT_LT(now - before, 0.04 * all) << "nothing pops";
      before = now;
    }
    EXPECT_EQ(growth_front(growth, 1), 0);
    EXPECT_DOUBLE_EQ(before, all);
  }
  Growth out{.duration = 1, .ripen = 1, .ease = Ease::out}, in{.duration = 1, .ripen = 1, .ease = Ease::in};
  EXPECT_DOUBLE_EQ(growth_front(out, 0.5), 1.5);
  EXPECT_DOUBLE_EQ(growth_front(in, 0.5), 0.5);
}

TEST(Film, HasNoJumps) {
  // The whole film, 24 frames a second: no node moves in one frame more than 12 times what nodes move on
  // average over the film.
  Skeleton s = candelabrum(20, Seed{5});
  Motion motion = lively();
  double total = 0, count = 0;
  float most = 0;
  Pose last = posed(s, motion, 0);
  for (int frame = 1; frame < 96; ++frame) {
    Pose now = posed(s, motion, frame / 24.0);
    for (std::size_t i = 0; i < s.size(); ++i) {
      float step = glm::distance(now.position[i], last.position[i]);
      most = std::max(most, step);
      total += step;
      count += 1;
    }
    last = now;
  }
  EXPECT_LT(most, 12 * total / count);
}

TEST(Growth, ByRateKeepsToTheLengthOfEachYear) {
  Skeleton s = candelabrum(7, Seed{1});
  set_births(s);
  Growth slow;
  slow.rate = 2, slow.years_a_second = 1, slow.start = 0.5, slow.ease = Ease::none;
  slow = paced(slow, s.longest());
  for (double years : {3.0, 8.0, 20.0, 40.0}) {
    const double length = std::min(0.02 * years, static_cast<double>(s.longest()));
    const double front = std::min(growth_front(slow, 0.5 + years), 1.0);
    EXPECT_NEAR(front * static_cast<double>(s.longest()), length, 0.01 * length) << years;
  }
  Growth fast = slow;
  fast.rate = 10;
  EXPECT_NEAR(paced(fast, 1).duration, paced(slow, 1).duration / 5, 1e-9);
  fast.rate = 0, fast.duration = 3;
  EXPECT_EQ(paced(fast, 7).duration, 3) << "without a rate its own duration holds";
}

}  // namespace
}  // namespace frond
