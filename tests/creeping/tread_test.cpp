#include "creeping/tread.h"

#include <gtest/gtest.h>

#include "creeping/meshes.h"

namespace frond {
namespace {

DVec3 unit(Seed s) {
  return glm::normalize(DVec3(s.child(1).normal(), s.child(2).normal(), s.child(3).normal()));
}

TEST(Tread, TangentIsTheDirectionWithoutItsShareAlongTheNormal) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    DVec3 n = unit(Seed{1}.child(i)), v = unit(Seed{2}.child(i)) * 3.0;
    DVec3 t = tangent(v, n);
    EXPECT_NEAR(glm::dot(t, n), 0, 1e-12);
    EXPECT_NEAR(glm::length(t), 1, 1e-12);
    DVec3 by_hand = glm::normalize(glm::cross(n, glm::cross(v, n)));
    EXPECT_LT(glm::distance(t, by_hand), 1e-9);
    EXPECT_LT(glm::distance(tangent(t, n), t), 1e-12);
  }
  EXPECT_NEAR(glm::dot(tangent(DVec3(0, 2, 0), DVec3(0, 1, 0)), DVec3(0, 1, 0)), 0, 1e-12);
}

TEST(Tread, WanderKeepsLengthAndTangency) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    DVec3 n = unit(Seed{3}.child(i)), t = tangent(unit(Seed{4}.child(i)), n);
    double angle = Seed{5}.child(i).range(-kPi, kPi);
    DVec3 w = turned(t, n, angle);
    EXPECT_NEAR(glm::dot(w, n), 0, 1e-12);
    EXPECT_NEAR(glm::length(w), 1, 1e-12);
    EXPECT_NEAR(std::atan2(glm::dot(n, glm::cross(t, w)), glm::dot(t, w)), angle, 1e-9);
  }
}

TEST(Tread, BiasGoesFromTheHeadingToTheDirection) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    DVec3 n = unit(Seed{6}.child(i)), t = tangent(unit(Seed{7}.child(i)), n);
    DVec3 goal = unit(Seed{8}.child(i)) * 5.0;
    EXPECT_EQ(leaning(t, n, goal, 0), t);
    EXPECT_LT(glm::distance(leaning(t, n, goal, 1), tangent(goal, n)), 1e-9);
    double before = -1;
    for (double share : {0.0, 0.2, 0.5, 0.8, 1.0}) {
      DVec3 w = leaning(t, n, tangent(goal, n), share);
      EXPECT_NEAR(glm::dot(w, n), 0, 1e-12);
      EXPECT_NEAR(glm::length(w), 1, 1e-12);
      // In the plane, by just that share of the angle.
      double whole = std::acos(glm::clamp(glm::dot(t, tangent(goal, n)), -1.0, 1.0));
      if (whole < 3) {
        EXPECT_NEAR(std::acos(glm::clamp(glm::dot(t, w), -1.0, 1.0)), share * whole, 1e-6);
      }
      double along = glm::dot(w, tangent(goal, n));
      EXPECT_GE(along, before - 1e-12);
      before = along;
    }
  }
}

TEST(Tread, BiasTurnsEvenWhatRunsStraightAway) {
  DVec3 n(0, 0, 1);
  DVec3 w = leaning(DVec3(0, -1, 0), n, DVec3(0, 1, 0), 0.25);
  EXPECT_NEAR(w.y, -std::cos(0.25 * kPi), 1e-9);
}

/// Walks straight on and checks each stride.
void walk(const TriangleSurface& host, Tread tread, double step, double lift, int count, double least_way) {
  DVec3 first = tread.place;
  double farthest = 0, way = 0;
  for (int i = 0; i < count; ++i) {
    Stride s = stride(host, tread, step, lift);
    ASSERT_NE(s.footing, Footing::stuck) << i;
    ASSERT_LE(s.length, step * 1.5) << i;
    ASSERT_NEAR(glm::dot(s.tread.heading, s.tread.normal), 0, 1e-9);
    ASSERT_NEAR(glm::length(s.tread.heading), 1, 1e-9);
    ASSERT_FALSE(host.inside(s.tread.place)) << i;
    double off = host.closest(s.tread.place)->distance;
    ASSERT_LE(off, 1.01 * lift) << i;
    way += s.length;
    tread = s.tread;
    farthest = std::max(farthest, glm::distance(first, tread.place));
  }
  EXPECT_GT(farthest, 0.3 * host.size());
  EXPECT_GT(way, least_way * step * count);
}

TEST(Tread, GoesRoundACube) {
  TriangleSurface host = std::move(*TriangleSurface::build(cube(1, 2)));
  for (double angle : {0.0, 0.3, 0.7, 1.1}) {
    Tread t = *tread_at(host, DVec3(0.1, 1, 0.05), DVec3(std::cos(angle), 0, std::sin(angle)), 0.002);
    walk(host, t, 0.03, 0.002, 400, 0.9);
  }
}

TEST(Tread, GoesRoundABallOnAGreatCircle) {
  TriangleSurface host = std::move(*TriangleSurface::build(ball(1, 320, 160)));
  Tread t = *tread_at(host, DVec3(1, 0, 0), DVec3(0, 1, 1), 0.002);
  DVec3 pole = glm::normalize(glm::cross(t.place, t.heading));
  for (int i = 0; i < 400; ++i) {
    t = stride(host, t, 0.02, 0.002).tread;
    ASSERT_LT(std::abs(glm::dot(t.place, pole)), 0.02) << i;
  }
}

TEST(Tread, ClimbsOutOfACorner) {
  TriangleSurface host = std::move(*TriangleSurface::build(corner()));
  Tread t = *tread_at(host, DVec3(0, 0.2, 0.5), DVec3(0.1, 0, -1), 0.002);
  for (int i = 0; i < 100; ++i) t = stride(host, t, 0.03, 0.002).tread;
  EXPECT_GT(t.place.y, 1);
  EXPECT_GT(t.normal.z, 0.99);
  EXPECT_GT(t.heading.y, 0.9);
}

TEST(Tread, WalksOnEverything) {
  for (const Surface& s : {bumpy_rock(5), ring(1, 0.3, 120, 60), wall_with_openings(), thin_wall()}) {
    TriangleSurface host = std::move(*TriangleSurface::build(s));
    for (std::uint64_t i = 0; i < 40; ++i) {
      Seed own = Seed{9}.child(i);
      DVec3 p = unit(own) * host.size();
      Tread t = *tread_at(host, p, unit(own.child("way")), 0.001 * host.size());
      double step = 0.008 * host.size();
      double lift = 0.001 * host.size();
      for (int k = 0; k < 300; ++k) {
        t.heading = turned(t.heading, t.normal, own.child(k).range(-0.3, 0.3));
        Stride next = stride(host, t, step, lift);
        ASSERT_NE(next.footing, Footing::stuck) << i << " " << k;
        ASSERT_FALSE(host.inside(next.tread.place)) << i << " " << k;
        ASSERT_LE(host.closest(next.tread.place)->distance, 1.01 * lift);
        t = next.tread;
      }
    }
  }
}

}  // namespace
}  // namespace frond
