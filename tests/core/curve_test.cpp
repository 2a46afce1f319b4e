#include "core/curve.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frond {
namespace {

TEST(Curve, PassesThroughItsPointsAndStaysBetweenThem) {
  Curve curve({{0, 1}, {0.3f, 0.9f}, {0.5f, 0.2f}, {1, 0.2f}});
  EXPECT_FLOAT_EQ(static_cast<float>(curve(0.3)), 0.9f);
  EXPECT_DOUBLE_EQ(curve(-1), 1);
  EXPECT_FLOAT_EQ(static_cast<float>(curve(2)), 0.2f);
  double last = 2;
  for (double x = 0; x <= 1; x += 0.001) {
    double y = curve(x);
    EXPECT_LE(y, last + 1e-9) << "rises at " << x;
    EXPECT_GE(y, 0.2f - 1e-6);
    last = y;
  }
}

TEST(Curve, OfTwoPointsIsALine) {
  Curve curve({{0, 0}, {2, 1}});
  EXPECT_NEAR(curve(0.5), 0.25, 1e-9);
  EXPECT_NEAR(curve(1.5), 0.75, 1e-9);
}

TEST(Curve, OfNoPointsIsOne) { EXPECT_EQ(Curve()(0.4), 1); }

TEST(Animated, IsSmoothAndRestsAtItsEnds) {
  Animated<double> value(std::vector<Animated<double>::Key>{{0, 0}, {1, 2}, {3, 1}});
  EXPECT_EQ(value.at(-1), 0);
  EXPECT_EQ(value.at(1), 2);
  EXPECT_EQ(value.at(9), 1);
  double step = 1e-4, speed = 0;
  for (double t = 0; t < 3; t += step) {
    double now = (value.at(t + step) - value.at(t)) / step;
    EXPECT_LT(std::abs(now - speed), 0.01) << "the speed jumps at " << t;
    speed = now;
  }
}

TEST(Animated, AKeyMaySayHowItGoesOn) {
  using Key = Animated<double>::Key;
  for (Ease ease : {Ease::none, Ease::in, Ease::out, Ease::both}) {
    Animated<double> value(std::vector<Key>{{0, 0}, {1, 2, ease}, {3, 6}, {4, 0}});
    for (double share : {0.0, 0.25, 0.6, 1.0})
      EXPECT_NEAR(value.at(1 + 2 * share), 2 + 4 * eased(ease, share), 1e-12);
    Animated<double> plain(std::vector<Key>{{0, 0}, {1, 2}, {3, 6}, {4, 0}});
    EXPECT_EQ(value.at(0.4), plain.at(0.4)) << "the ways beside it are as they were";
    EXPECT_EQ(value.at(3.4), plain.at(3.4));
    EXPECT_FALSE(value == plain);
  }
}

TEST(Animated, HandlesBendTheWay) {
  using Key = Animated<Vec3>::Key;
  Vec3 up(0, 3, 0);
  Animated<Vec3> path(std::vector<Key>{{0, Vec3(0), {}, {}, up}, {2, Vec3(6, 0, 0), {}, up, {}}});
  EXPECT_NEAR(path.at(1).y, 2.25, 1e-6) << "three quarters of the way to the control points";
  EXPECT_NEAR(path.at(1).x, 3, 1e-6);
  EXPECT_EQ(path.at(2), Vec3(6, 0, 0));
  // The handle that is missing is opposite, so that the way goes on in the same direction.
  Animated<Vec3> through(std::vector<Key>{{0, Vec3(0)}, {1, Vec3(1, 0, 0), {}, {}, up}, {2, Vec3(2, 0, 0)}});
  Vec3 before = through.at(1) - through.at(0.999), after = through.at(1.001) - through.at(1);
  EXPECT_GT(after.y, 0.005);
  EXPECT_NEAR(before.y, after.y, 1e-4);
  // With an ease it goes the same way at another pace.
  Animated<Vec3> late(std::vector<Key>{{0, Vec3(0), Ease::in, {}, up}, {2, Vec3(6, 0, 0), {}, up, {}}});
  EXPECT_NEAR(late.at(std::sqrt(2)).y, 2.25, 1e-5);
}

TEST(Animated, MovesVectors) {
  Animated<Vec3> path(std::vector<Animated<Vec3>::Key>{{0, Vec3(0)}, {2, Vec3(2, 4, -6)}});
  Vec3 middle = path.at(1);
  EXPECT_NEAR(middle.x, 1, 1e-6);
  EXPECT_NEAR(middle.y, 2, 1e-6);
  EXPECT_NEAR(middle.z, -3, 1e-6);
  EXPECT_TRUE(Animated<Vec3>(Vec3(1)).constant());
}

}  // namespace
}  // namespace frond
