#include "motion/wind.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frond {
namespace {

TEST(Wind, AGustArrivesDownwindLater) {
  WindField field = wind_field({8, 0.3, Vec3(1, 0, 1)}, 0, Seed{1});
  for (double time : {0.0, 2.3, 11.9})
    for (float far : {5.0f, 40.0f}) {
      Vec3 near(3, 0, -2), down = near + far * field.along;
      EXPECT_NEAR(field.gust(down, time + far / 8), field.gust(near, time), 1e-4);
    }
}

TEST(Wind, KeepsItsDeviationAndRepeats) {
  double length = 12, sum = 0, squares = 0;
  WindField field = wind_field({8, 0.3, Vec3(1, 0, 0)}, length, Seed{1});
  int steps = 0;
  for (int row = 0; row < 40; ++row)
    for (double t = 0; t < length; t += 0.05, ++steps) {
      double g = field.gust(Vec3(0, 0, 97.0f * static_cast<float>(row)), t);
      sum += g, squares += g * g;
    }
  EXPECT_NEAR(sum / steps, 0, 0.02);
  EXPECT_NEAR(std::sqrt(squares / steps), 0.3, 0.06);
  for (double t : {0.0, 1.7})
    EXPECT_NEAR(field.gust(Vec3(5, 0, 9), t), field.gust(Vec3(5, 0, 9), t + length), 1e-6);
}

TEST(Wind, WhatGustsCarryIsTheirSumOverTime) {
  WindField field = wind_field({.speed = 5, .gusts = 0.4}, 6, Seed{3});
  constexpr double kStep = 1e-3;
  for (double time : {0.0, 1.7, 4.4})
    EXPECT_NEAR(
        (field.carried({2, 0, 1}, time + kStep) - field.carried({2, 0, 1}, time - kStep)) / (2 * kStep),
        field.gust({2, 0, 1}, time), 1e-3);
  EXPECT_NEAR(field.carried({2, 0, 1}, 6), field.carried({2, 0, 1}, 0), 1e-9);
}

TEST(Wind, AStormComesAndGoes) {
  WindField field = wind_field({6, 0.2, Vec3(1, 0, 0)}, 0, Seed{1}, {{10, 2, 25}});
  EXPECT_NEAR(field.mean(10), 25, 1e-9);
  EXPECT_NEAR(field.mean(0), 6, 0.01);
  EXPECT_NEAR(field.mean(20), 6, 0.01);
  EXPECT_LT(std::abs(field.mean(9.5) - field.mean(9.5 + 1.0 / 24)), 1);
}

TEST(Wind, ItsPressureGrowsSteadilyAndSlowerInStorms) {
  double before = 0;
  for (double speed = 0.5; speed < 60; speed += 0.5) {
    double pressure = drag_pressure(speed), step = 0.01 * speed;
    EXPECT_GT(pressure, before);
    before = pressure;
    double power = std::log(drag_pressure(speed + step) / pressure) / std::log(1.01);
    EXPECT_NEAR(power, drag_power(speed), 0.01);
  }
  EXPECT_NEAR(drag_power(1), 2, 0.01);
  EXPECT_LT(drag_power(40), 1.4);
}

}  // namespace
}  // namespace frond
