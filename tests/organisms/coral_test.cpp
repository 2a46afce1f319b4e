#include "organisms/coral/coral.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frond {
namespace {

Skeleton grown(const CoralParams& params, Seed seed = Seed{1}) {
  Result<Skeleton> coral = grow_coral(params, seed);
  EXPECT_TRUE(coral.ok());
  return *coral;
}

CoralParams plain() {
  CoralParams params;
  params.steps = 3;
  params.angle_jitter = 0;
  params.length_jitter = 0;
  params.lift = 0;
  params.smoothing = 1;
  params.distortion.strength = 0;
  return params;
}

TEST(Coral, GrowsByBothGrammars) {
  // C1: each A makes three branches of three segments; three steps make 3 + 9 + 27 branches.
  for (CoralForm form : {CoralForm::branching, CoralForm::tufted}) {
    CoralParams params = plain();
    params.form = form;
    Skeleton s = grown(params);
    EXPECT_EQ(s.find_fault(), "");
    EXPECT_EQ(s.size(), 3u + 3 * (3 + 9 + 27));  // and a root for each of the first three
    EXPECT_NEAR(s.longest(), 3 * 3 * params.internode, 1e-5);
  }
}

TEST(Coral, TurnsByPitchAndRoll) {
  CoralParams params = plain();
  params.steps = 1;
  params.pitch = radians(25.0);
  params.roll = radians(45.0);
  Skeleton s = grown(params);
  // The first branch pitches by 25 degrees, the second is rolled by 180 and leans the other way.
  auto lean = [&](std::size_t node) {
    return std::atan2(std::hypot(s.position[node].x, s.position[node].z), s.position[node].y);
  };
  EXPECT_NEAR(degrees(lean(1)), 25, 0.01);
  EXPECT_NEAR(degrees(lean(5)), 25, 0.01);
  EXPECT_LT(glm::dot(Vec3(s.position[1].x, 0, s.position[1].z), Vec3(s.position[5].x, 0, s.position[5].z)),
            0);
}

TEST(Coral, LongerAndThinnerFromHereOn) {
  CoralParams params = plain();
  params.steps = 2;
  params.length_scale = 2;
  params.width_scale = 0.5;
  params.thickness = {0.1, Curve({{0, 1}, {1, 1}}), 1, 0};
  Skeleton s = grown(params);
  // Depth 1: one " and one !; depth 2: two of each.
  EXPECT_NEAR(s.longest(), 3 * params.internode * 2 + 3 * params.internode * 4, 1e-5);
  EXPECT_NEAR(s.radius[1], 0.05f, 1e-6);
  EXPECT_NEAR(*std::min_element(s.radius.begin(), s.radius.end()), 0.025f, 1e-6);
}

TEST(Thickness, FollowsTheCurve) {
  CoralParams params = plain();
  params.width_scale = 1;
  params.thickness = {0.08, Curve({{0, 0.25f}, {1, 1}}), 1, 0};
  Skeleton s = grown(params);
  for (std::size_t i = 0; i < s.size(); ++i) {
    float left = 1 - s.distance[i] / s.longest();
    EXPECT_NEAR(s.radius[i], 0.08f * (0.25f + 0.75f * left), 1e-5) << i;
  }
}

TEST(Distortion, LeavesTheBaseAndBendsTheTips) {
  CoralParams params = plain();
  Skeleton straight = grown(params);
  params.distortion = {0.1, 0.3};
  Skeleton bent = grown(params);
  ASSERT_EQ(straight.size(), bent.size());
  EXPECT_EQ(bent.position[0], straight.position[0]);
  float most = 0;
  for (std::size_t i = 0; i < bent.size(); ++i) {
    float moved = glm::distance(bent.position[i], straight.position[i]);
    float share = straight.distance[i] / straight.longest();
    EXPECT_LE(moved, 0.1f * share * 1.7321f + 1e-5f);
    most = std::max(most, moved);
  }
  EXPECT_GT(most, 0.03f);
}

TEST(Coral, IsScaledToItsHeight) {
  CoralParams params = plain();
  params.height = 0.8;
  Skeleton s = grown(params);
  float top = 0;
  for (const Vec3& p : s.position) top = std::max(top, p.y);
  EXPECT_NEAR(top, 0.8f, 1e-5);
}

TEST(Coral, DiffersBySeedOnly) {
  CoralParams params;
  params.steps = 3;
  EXPECT_EQ(grown(params, Seed{4}).position, grown(params, Seed{4}).position);
  EXPECT_NE(grown(params, Seed{4}).position, grown(params, Seed{5}).position);
}

TEST(Coral, TellsOfABrokenGrammar) {
  CoralParams params;
  params.form = CoralForm::own;
  params.grammar.axiom = "F[+F";
  EXPECT_FALSE(grow_coral(params, Seed{1}).ok());
  params.grammar.axiom = "X";
  EXPECT_FALSE(grow_coral(params, Seed{1}).ok());
}

TEST(Coral, WhatStopsItsGrammarNamesThePlace) {
  CoralParams params;
  params.form = CoralForm::own;
  params.grammar.where = "reef.json:3:5: /organisms/0/grammar";
  params.grammar.rules.emplace_back().text = "F(x) : x > 0 -> F(x)F(x)";
  params.grammar.axiom = "F(1)";
  params.grammar.steps = 30;
  params.grammar.limits.modules = 1000;
  Result<Skeleton> coral = grow_coral(params, Seed{1});
  ASSERT_FALSE(coral.ok());
  EXPECT_EQ(coral.errors()[0].where, params.grammar.where);
  params.grammar.limits = {};
  params.grammar.steps = 1;
  params.grammar.axiom = "F(1e30)";
  EXPECT_EQ(grow_coral(params, Seed{1}).errors()[0].where, params.grammar.where);
}

}  // namespace
}  // namespace frond
