#include "motion/sway.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/posed.h"

namespace frond {
namespace {

std::shared_ptr<const WindField> windy(double speed, double film = 0, double gusts = 0.25) {
  return std::make_shared<const WindField>(wind_field({speed, gusts, Vec3(1, 0, 0)}, film, Seed{7}));
}

/// A bare rod of 10 m, straight up.
Model rod(float radius = 0.05f, int nodes = 200, Vec3 along = Vec3(0, 1, 0)) {
  Model m;
  Skeleton& s = m.skeleton;
  std::int32_t below = s.add(Vec3(0), radius, Skeleton::kRoot, 0);
  for (int i = 1; i <= nodes; ++i)
    below = s.add(along * (10.0f * static_cast<float>(i) / static_cast<float>(nodes)), radius, below, 0);
  set_tip_distances(s);
  return m;
}

/// The same with level limbs of 2 m and hanging twigs.
Model with_limbs() {
  Model m = rod();
  Skeleton& s = m.skeleton;
  for (std::int32_t at : {80, 120, 160, 199})
    for (float side : {-1.0f, 1.0f}) {
      std::int32_t below = at, tip = at;
      auto from = [&](std::int32_t node) { return s.position[static_cast<std::size_t>(node)]; };
      for (int k = 0; k < 20; ++k) below = s.add(from(below) + Vec3(0.03f * side, 0, 0.1f), 0.01f, below, 1);
      tip = below;
      for (int k = 0; k < 10; ++k) below = s.add(from(below) - Vec3(0, 0.1f, 0), 0.002f, below, 2);
      EXPECT_GT(below, tip);
    }
  set_tip_distances(s);
  return m;
}

Motion in_wind(const Model& m, std::shared_ptr<const WindField> wind, SwayWood wood = {}) {
  Motion motion;
  motion.limbs = true, motion.film_length = 6;
  motion.sway = std::make_shared<const Sway>(sway_of(m, wood, std::move(wind)));
  return motion;
}

TEST(Sway, ARodSwingsAsEulerAndBernoulliHaveIt) {
  Sway sway = sway_of(rod(), {}, windy(6));
  double radius = 0.05, length = 10, a = kPi * radius * radius, i = kPi / 4 * std::pow(radius, 4);
  double unit = std::sqrt(0.45 * 8e9 * i / (900 * a * std::pow(length, 4)));
  EXPECT_NEAR(sway.stem().rate, 3.5160 * unit, 0.01 * 3.5160 * unit);
  EXPECT_NEAR(sway.stem_second.rate, 22.034 * unit, 0.02 * 22.034 * unit);
}

TEST(Sway, AHangingThreadSwingsAsAChain) {
  SwayWood soft{900, 1e7, 0.5};
  Sway sway = sway_of(rod(0.002f, 400, Vec3(0, -1, 0)), soft, windy(6));
  // The first zero of J0 (Bernoulli 1738).
  double chain = 2.4048 / 2 * std::sqrt(9.81 / 10);
  EXPECT_NEAR(sway.limbs[0].mode.rate, chain, 0.1 * chain);
}

TEST(Sway, SegmentsKeepTheirLengthsAndTheRootStays) {
  Model m = with_limbs();
  const Skeleton& s = m.skeleton;
  for (double speed : {5.0, 30.0, 60.0}) {
    Motion motion = in_wind(m, windy(speed));
    for (double time : {0.0, 1.3, 7.7}) {
      Pose pose = posed(s, motion, time);
      EXPECT_EQ(pose.position[0], s.position[0]);
      for (std::size_t i = 1; i < s.size(); ++i) {
        float rest = glm::distance(s.position[i], s.position[s.parent[i]]);
        EXPECT_NEAR(glm::distance(pose.position[i], pose.position[s.parent[i]]), rest, 1e-4f);
      }
    }
  }
}

TEST(Sway, StrongerWindBendsMoreAndNeverPastItself) {
  Model m = rod(0.02f);
  float before = 0;
  for (double speed : {1.0, 3.0, 6.0, 12.0, 20.0, 30.0, 45.0, 60.0}) {
    Pose pose = posed(m.skeleton, in_wind(m, windy(speed, 0, 0)), 0);
    Vec3 tip = pose.position.back();
    EXPECT_GT(tip.x, before);
    EXPECT_NEAR(tip.z, 0, 1e-4f);
    before = tip.x;
    for (const Quat& turn : pose.turn) EXPECT_GT((turn * Vec3(0, 1, 0)).y, -1e-3f) << speed;
  }
}

TEST(Sway, WhatBreaksOffIsWhereTheLimbWasAndComesToRestOnTheGround) {
  Model whole = with_limbs(), broken = whole;
  Skeleton& s = broken.skeleton;
  std::size_t piece = 201;
  Vec3 foot = s.position[static_cast<std::size_t>(s.parent[piece])];
  for (float height : {foot.y, 0.0f}) {
    std::int32_t at = broken.skeleton.add(Vec3(foot.x, height, foot.z), 0.01f, Skeleton::kRoot, 1);
    broken.skeleton.add(Vec3(foot.x, height, foot.z + 1), 0.01f, at, 1);
  }
  set_tip_distances(s);
  Pose before = posed(whole.skeleton, in_wind(whole, windy(20)), 1);
  Pose after = posed(s, in_wind(broken, windy(20)), 1);
  auto stood = static_cast<std::size_t>(whole.skeleton.parent[piece]);
  EXPECT_GT(glm::distance(before.position[stood], foot), 0.05f);
  EXPECT_LT(glm::distance(after.position[s.size() - 4], before.position[stood]), 0.02f);
  EXPECT_LT(glm::distance(after.position[s.size() - 2], s.position[s.size() - 2]), 1e-5f);
}

TEST(Sway, RepeatsWithTheFilm) {
  Model m = with_limbs();
  Motion motion = in_wind(m, windy(12, 6));
  Pose first = posed(m.skeleton, motion, 0), again = posed(m.skeleton, motion, 6);
  for (std::size_t i = 0; i < m.skeleton.size(); ++i)
    EXPECT_LT(glm::distance(first.position[i], again.position[i]), 1e-4f);
}

TEST(Sway, NothingJumps) {
  Model m = with_limbs();
  WindField field = wind_field({12, 0.25, Vec3(1, 0, 0)}, 0, Seed{7}, {{1, 0.5, 30}});
  Motion motion = in_wind(m, std::make_shared<const WindField>(field));
  float all = 0, most = 0;
  for (int frame = 0; frame < 48; ++frame) {
    Pose now = posed(m.skeleton, motion, frame / 24.0), next = posed(m.skeleton, motion, (frame + 1) / 24.0);
    float moved = glm::distance(now.position.back(), next.position.back());
    all += moved, most = std::max(most, moved);
  }
  EXPECT_GT(all, 0.05f);
  EXPECT_LT(most, 8 * all / 48);
}

TEST(Sway, LeavesAndSnowMakeItSlowerAndTheWindDoesNot) {
  Model leafy = rod();
  Prototype leaf{"leaf", {{}}, {Color{}}, {}};
  leaf.parts[0].surface.position = {Vec3(0), Vec3(2, 0, 0), Vec3(0, 1, 0)};
  leaf.parts[0].surface.triangle = {{0, 1, 2}};
  leafy.prototypes.push_back(leaf);
  Organs& o = leafy.organs;
  for (std::int32_t node = 100; node < 200; ++node) {
    o.prototype.push_back(0), o.node.push_back(node);
    o.position.push_back(leafy.skeleton.position[static_cast<std::size_t>(node)]);
    o.turn.push_back(Quat(1, 0, 0, 0)), o.scale.push_back(Vec3(0.5f));
  }
  EXPECT_NEAR(leaf_areas(leafy)[150], 0.25f, 1e-6f);
  Sway bare = sway_of(rod(), {}, windy(6)), summer = sway_of(leafy, {}, windy(6));
  Sway snowy = sway_of(leafy, {900, 8e9, 4}, windy(6)), storm = sway_of(leafy, {}, windy(30));
  EXPECT_LT(summer.stem().rate, bare.stem().rate);
  EXPECT_LT(snowy.stem().rate, summer.stem().rate);
  EXPECT_EQ(storm.stem().rate, summer.stem().rate);
  EXPECT_GT(summer.stem().damping, bare.stem().damping);
}

TEST(Sway, TheAnswerIsTheOscillators) {
  // One gust far slower than the rod moves it as a steady wind does, one far faster hardly.
  Model m = rod();
  for (auto [ratio, least, most] : {std::tuple{0.05, 0.95, 1.05}, {1.0, 2.0, 11.0}, {8.0, 0.0, 0.05}}) {
    WindField field = *windy(6, 0, 0);
    field.gusts = {{ratio * sway_of(m, {}, windy(6)).stem().rate, Vec2(0), 0, 0.1}};
    Sway sway = sway_of(m, {}, std::make_shared<const WindField>(field));
    double answer = std::abs(sway.response[0]) / 0.1;
    EXPECT_GE(answer, least) << ratio;
    EXPECT_LE(answer, most) << ratio;
  }
}

}  // namespace
}  // namespace frond
