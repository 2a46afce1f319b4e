#include "creeping/triangle_surface.h"

#include <gtest/gtest.h>

#include "creeping/meshes.h"

namespace frond {
namespace {

DVec3 anywhere(Seed seed, double size) {
  return {seed.child(1).range(-size, size), seed.child(2).range(-size, size),
          seed.child(3).range(-size, size)};
}

TEST(TriangleSurface, FindsTheNearestPointOfABall) {
  TriangleSurface host = built(ball(1, 200, 100));
  EXPECT_TRUE(host.closed());
  for (std::uint64_t i = 0; i < 2000; ++i) {
    DVec3 p = anywhere(Seed{1}.child(i), 1.5);
    Contact c = *host.closest(p);
    double r = glm::length(p);
    EXPECT_NEAR(c.distance, std::abs(r - 1), 1e-3) << i;
    EXPECT_GT(glm::dot(c.normal, p / r), 0.995) << i;
    if (std::abs(r - 1) > 2e-3) {
      EXPECT_EQ(c.inside, r < 1) << i;
      EXPECT_EQ(host.inside(p), r < 1) << i;
    }
  }
}

TEST(TriangleSurface, AgreesWithLookingAtEveryTriangle) {
  Surface s = bumpy_rock(3);
  TriangleSurface host = built(s);
  for (std::uint64_t i = 0; i < 300; ++i) {
    DVec3 p = anywhere(Seed{2}.child(i), 0.7);
    Contact c = *host.closest(p);
    // No triangle has a point that is nearer: sample them all.
    double best = 1e9;
    for (auto [a, b, d] : s.triangle)
      for (int u = 0; u <= 8; ++u)
        for (int v = 0; u + v <= 8; ++v) {
          DVec3 q = (DVec3(s.position[a]) * double(u) + DVec3(s.position[b]) * double(v) +
                     DVec3(s.position[d]) * double(8 - u - v)) /
                    8.0;
          best = std::min(best, glm::distance(p, q));
        }
    EXPECT_LE(c.distance, best + 1e-9);
    EXPECT_GE(c.distance, best - 0.02);
    EXPECT_NEAR(glm::distance(c.point, p), c.distance, 1e-12);
  }
}

TEST(TriangleSurface, ALikelyTriangleChangesNothing) {
  TriangleSurface host = built(cube(1, 4));
  for (std::uint64_t i = 0; i < 1000; ++i) {
    DVec3 p = anywhere(Seed{3}.child(i), 0.8);
    // Many of these have several nearest triangles.
    if (i % 2) p = glm::round(p * 4.0) / 4.0;
    Contact a = *host.closest(p);
    auto likely = static_cast<std::uint32_t>(i % host.triangles().size());
    Contact b = *host.closest(p, 10, likely);
    EXPECT_EQ(a.point, b.point);
    EXPECT_EQ(a.triangle, b.triangle);
    EXPECT_EQ(a.normal, b.normal);
  }
}

TEST(TriangleSurface, NormalsAreContinuousRoundAnEdge) {
  TriangleSurface host = built(cube(1, 1));
  DVec3 before(0);
  for (int i = 0; i <= 1000; ++i) {
    double angle = -0.3 + (0.5 * kPi + 0.6) * i / 1000;
    DVec3 p = DVec3(0.5, 1, 0) + 0.05 * DVec3(std::sin(angle), std::cos(angle), 0);
    if (host.inside(p)) continue;
    DVec3 n = host.closest(p)->normal;
    if (before != DVec3(0)) {
      EXPECT_GT(glm::dot(before, n), std::cos(0.004)) << i;
    }
    before = n;
  }
}

TEST(TriangleSurface, SeesBothSidesOfAThinWall) {
  TriangleSurface host = built(bricks(1, 1, 1, Vec3(4, 2, 0.002f), [](int, int, int) { return true; }));
  EXPECT_GT(host.closest(DVec3(0.3, 1, 0.002))->normal.z, 0.99);
  EXPECT_LT(host.closest(DVec3(0.3, 1, -0.002))->normal.z, -0.99);
  EXPECT_TRUE(host.inside(DVec3(0.3, 1, 0)));
  EXPECT_FALSE(host.inside(DVec3(0.3, 1, 0.0015)));
}

TEST(TriangleSurface, CrossingsAreTheFirstOnTheWay) {
  TriangleSurface host = built(ball(1, 200, 100));
  auto in = host.crossing(DVec3(-2, 0.1, 0.2), DVec3(2, 0.1, 0.2));
  ASSERT_TRUE(in);
  EXPECT_NEAR(-2 + 4 * in->share, -std::sqrt(1 - 0.05), 2e-3);
  EXPECT_LT(in->normal.x, -0.9);
  EXPECT_FALSE(host.crossing(DVec3(-2, 0, 0), DVec3(-1.1, 0, 0)));
  EXPECT_FALSE(host.crossing(DVec3(-0.5, 0, 0), DVec3(0.5, 0, 0)));
}

TEST(TriangleSurface, SurvivesWhatScannersGive) {
  TriangleSurface host = built(scanned(Seed{1}));
  EXPECT_FALSE(host.closed());
  // Flipped faces are turned back: nearly all look away from the middle.
  std::size_t outward = 0;
  for (std::uint32_t t = 0; t < host.triangles().size(); ++t)
    outward += glm::dot(host.face_normal(t), DVec3(host.triangles()[t][0])) > 0;
  EXPECT_GT(static_cast<double>(outward), 0.98 * static_cast<double>(host.triangles().size()));
}

TEST(TriangleSurface, TurnsOpenPiecesOutward) {
  // Most of a ball, inside out.
  Surface s = ball(1, 40, 20);
  std::erase_if(s.triangle, [&](const auto& t) { return s.position[t[0]].y > 0.6f; });
  for (auto& t : s.triangle) std::swap(t[1], t[2]);
  TriangleSurface host = built(s);
  EXPECT_FALSE(host.closed());
  for (std::uint32_t t = 0; t < host.triangles().size(); ++t) {
    EXPECT_GT(glm::dot(host.face_normal(t), DVec3(host.triangles()[t][0])), 0);
    EXPECT_TRUE(host.behind(t, -host.face_normal(t)));
  }
}

TEST(TriangleSurface, TurnsClosedPiecesOutward) {
  Surface s = cube(1, 3);
  for (auto& t : s.triangle) std::swap(t[1], t[2]);
  TriangleSurface host = built(s);
  EXPECT_TRUE(host.closed());
  for (std::uint32_t t = 0; t < host.triangles().size(); ++t)
    EXPECT_GT(glm::dot(host.face_normal(t), DVec3(host.triangles()[t][0]) - DVec3(0, 0.5, 0)), 0.1);
}

TEST(TriangleSurface, RefusesWhatHasNoSurfaceByName) {
  Surface s;
  s.position = {Vec3(0), Vec3(1), Vec3(2), Vec3(NAN, 0, 0)};
  s.triangle = {{0, 1, 2}, {0, 1, 1}, {0, 1, 3}, {0, 1, 9}};
  auto host = TriangleSurface::build(s, "ruin.obj");
  ASSERT_FALSE(host);
  EXPECT_EQ(host.errors()[0].text(), "ruin.obj: none of the 4 triangles has an area");
  EXPECT_FALSE(TriangleSurface::build(Surface{}, "nothing"));
}

}  // namespace
}  // namespace frond
