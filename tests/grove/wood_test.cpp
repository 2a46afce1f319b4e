#include "grove/wood.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frond {
namespace {

struct Beam {
  std::vector<Vec3> tip;
  std::vector<std::int32_t> parent;
  std::vector<float> radius, leaves;
  Limbs limbs() const { return {tip, parent, radius, leaves}; }
};

Beam straight(Vec3 way, int pieces, float radius) {
  Beam beam;
  for (int i = 0; i <= pieces; ++i) {
    beam.tip.push_back(way * (static_cast<float>(i) / static_cast<float>(pieces)));
    beam.parent.push_back(i - 1);
    beam.radius.push_back(radius);
    beam.leaves.push_back(0);
  }
  return beam;
}

/// A level cantilever under its own weight: sigma = 2 rho g L^2 / r at its base.
TEST(Wood, ACantileverIsStressedAsTheBookSays) {
  Wood wood;
  for (float length : {0.5f, 2.0f, 6.0f}) {
    for (float radius : {0.01f, 0.08f}) {
      for (int pieces : {1, 7, 60}) {
        Beam beam = straight(Vec3(length, 0, 0), pieces, radius);
        double expected = 2 * wood.density * 9.81 * length * length / radius;
        EXPECT_NEAR(bending_stress(beam.limbs(), wood, {})[1], expected, 0.01 * expected)
            << length << ' ' << radius;
      }
    }
  }
}

/// A weight W at the end: M = W L, on top of the beam's own.
TEST(Wood, LeavesAtTheEndWeigh) {
  Wood wood;
  Beam beam = straight(Vec3(3, 0, 0), 30, 0.02f);
  float own = bending_stress(beam.limbs(), wood, {})[1];
  beam.leaves.back() = 4;
  double moment = 4 * wood.leaf_mass * 9.81 * 2.95;
  EXPECT_NEAR(bending_stress(beam.limbs(), wood, {})[1] - own, 4 * moment / (kPi * 8e-6), 0.01 * own);
}

TEST(Wood, AMastIsStressedByWindOnly) {
  Wood wood;
  Beam mast = straight(Vec3(0, 8, 0), 40, 0.1f);
  EXPECT_NEAR(bending_stress(mast.limbs(), wood, {})[1], 0, 1);
  // 0.5 rho v^2 d on each metre, the wind growing with height.
  double moment = 0;
  for (double y = 0.005; y < 8; y += 0.01) {
    double speed = 20 * std::pow(std::max(y / 10, 0.02), 0.2);
    moment += 0.5 * 1.2 * speed * speed * 0.2 * 0.01 * y;
  }
  double expected = 4 * moment / (kPi * 1e-3);
  EXPECT_NEAR(bending_stress(mast.limbs(), wood, {Vec3(20, 0, 0), 0})[1], expected, 0.03 * expected);
}

TEST(Wood, SnowLiesOnWhatIsLevel) {
  Wood wood;
  Beam level = straight(Vec3(2, 0, 0), 10, 0.03f);
  float bare = bending_stress(level.limbs(), wood, {})[1];
  double more = 30 * 0.06 * 9.81 * 2 / 2 * 2;  // q L^2 / 2
  EXPECT_NEAR(bending_stress(level.limbs(), wood, {Vec3(0), 30})[1] - bare, 4 * more / (kPi * 2.7e-5),
              0.02 * bare);
}

TEST(Wood, SnowWeighsTheSameWhicheverWayABranchPoints) {
  Wood wood;
  float east = bending_stress(straight(Vec3(2, 0.5f, 0), 10, 0.03f).limbs(), wood, {Vec3(0), 30})[1];
  for (Vec3 way : {Vec3(0, 0.5f, 2), Vec3(0, 0.5f, -2), Vec3(1.2f, 0.5f, 1.6f)}) {
    Beam beam = straight(way, 10, 0.03f);
    EXPECT_NEAR(bending_stress(beam.limbs(), wood, {Vec3(0), 30})[1], east, 1e-4f * east);
  }
}

/// Pipes of a hand-made fork: what parts there adds up.
TEST(Wood, PipesAddUpAndStay) {
  Metamers t;
  t.resize(5);
  t.parent = {Metamers::kRoot, 0, 1, 1, 3};
  thicken(t);
  EXPECT_FLOAT_EQ(t.pipe[2], 1);
  EXPECT_FLOAT_EQ(t.pipe[3], 1 + kLeafPipe);
  EXPECT_FLOAT_EQ(t.pipe[1], t.pipe[2] + t.pipe[3] + kLeafPipe);
  float before = t.pipe[1];
  t.keep({1, 1, 1, 0, 0});
  thicken(t);
  EXPECT_FLOAT_EQ(t.pipe[1], before) << "radii never shrink";
  Wood wood;
  EXPECT_NEAR(pipe_radius(wood, 32), 0.0025 * std::pow(32, 1 / 2.3), 1e-7);
}

/// A new shoot sags as its weight says, an old one no more.
TEST(Wood, NewShootsSag) {
  Wood wood;
  auto level = [] {
    Metamers t;
    t.resize(9);
    for (int i = 0; i < 9; ++i) {
      t.tip[i] = Vec3(0.1f * static_cast<float>(i), 5, 0);
      t.parent[i] = i - 1;
      t.side[i] = Vec3(0, 0, 1);
    }
    t.tip[0].y = 0;  // the foot lies lower
    thicken(t);
    return t;
  };
  Metamers t = level();
  sag(t, wood, 0, 2);
  float drop = 5 - t.tip[8].y;
  EXPECT_GT(drop, 0.002f);
  EXPECT_LT(drop, 0.2f);
  EXPECT_FLOAT_EQ(t.tip[1].y, 5);
  for (int i = 2; i < 9; ++i) EXPECT_NEAR(t.length(i), 0.1f, 1e-5f) << "shoots keep their length";
  Metamers leafy = level();
  sag(leafy, wood, 0.03, 2);
  EXPECT_LT(leafy.tip[8].y, t.tip[8].y);
  wood.stiffness *= 10;
  Metamers stiff = level();
  sag(stiff, wood, 0, 2);
  EXPECT_LT(5 - stiff.tip[8].y, 0.2f * drop);
}

}  // namespace
}  // namespace frond
