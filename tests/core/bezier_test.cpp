#include "core/bezier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "core/seed.h"

namespace frond {
namespace {

std::vector<glm::dvec2> random_points(int degree, Seed seed) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i <= degree; ++i) {
    Seed own = seed.child(static_cast<std::uint64_t>(i));
    points.push_back({own.child("x").range(-1, 1), own.child("y").range(-1, 1)});
  }
  return points;
}

/// The sum of Bernstein polynomials.
glm::dvec2 bernstein(const std::vector<glm::dvec2>& control, double t) {
  glm::dvec2 sum(0);
  auto n = static_cast<double>(control.size() - 1);
  double choose = 1;
  for (std::size_t i = 0; i < control.size(); ++i) {
    auto k = static_cast<double>(i);
    sum += control[i] * (choose * std::pow(t, k) * std::pow(1 - t, n - k));
    choose *= (n - k) / (k + 1);
  }
  return sum;
}

TEST(Bezier, IsTheBernsteinSumAtEachDegree) {
  for (int degree = 0; degree <= 20; ++degree) {
    std::vector<glm::dvec2> control = random_points(degree, Seed{5});
    for (double t : {0.0, 0.1, 0.37, 0.5, 0.93, 1.0})
      EXPECT_LT(glm::distance(bezier_jet(control, t).at, bernstein(control, t)), 1e-12) << degree;
  }
}

TEST(Bezier, DerivativesAreThoseOfTheCurve) {
  for (int degree = 1; degree <= 20; ++degree) {
    std::vector<glm::dvec2> control = random_points(degree, Seed{6});
    for (double t : {0.2, 0.5, 0.8}) {
      double h = 1e-4;
      auto before = bezier_jet(control, t - h), on = bezier_jet(control, t),
           after = bezier_jet(control, t + h);
      EXPECT_LT(glm::distance(on.slope, (after.at - before.at) / (2 * h)), 1e-3) << degree;
      EXPECT_LT(glm::distance(on.bend, (after.slope - before.slope) / (2 * h)), 0.05) << degree;
    }
  }
}

TEST(Bezier, RaisingTheDegreeKeepsTheCurve) {
  for (int degree = 0; degree <= 6; ++degree) {
    std::vector<glm::dvec2> control = random_points(degree, Seed{7}), raised = bezier_raised(control);
    ASSERT_EQ(raised.size(), control.size() + 1);
    for (double t : {0.0, 0.3, 0.7, 1.0})
      EXPECT_LT(glm::distance(bezier_jet(control, t).at, bezier_jet(raised, t).at), 1e-12);
  }
}

}  // namespace
}  // namespace frond
