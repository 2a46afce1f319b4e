#include "creeping/hang.h"

#include <gtest/gtest.h>

#include "creeping/crawl.h"
#include "creeping/meshes.h"
#include "creeping/swing.h"
#include "winding.h"

namespace frond {
namespace {

/// Far from everything.
TriangleSurface nowhere() { return built(ball(0.1, 8, 6)); }

Chain grown(const TriangleSurface& host, double stiffness, int links, DVec3 heading,
            DVec3 root = DVec3(10, 10, 0)) {
  Chain chain;
  chain.root = root;
  chain.heading = glm::normalize(heading);
  chain.stiffness = stiffness;
  for (int i = 0; i < links; ++i) {
    DVec3 last = i == 0 ? chain.heading
                        : glm::normalize(chain.place[i - 1] - (i == 1 ? chain.root : chain.place[i - 2]));
    lengthen(chain, host, glm::normalize(last + DVec3(0.01, 0, 0.02)));
    settle(chain, host, 4);
  }
  for (int i = 0; i < 100 && settle(chain, host, 20) > 1e-6; ++i) {
  }
  return chain;
}

TEST(Hang, LinksKeepTheirLength) {
  TriangleSurface host = nowhere();
  Chain chain = grown(host, 0.12, 50, DVec3(1, 0.5, 0));
  DVec3 at = chain.root;
  for (const DVec3& p : chain.place) {
    EXPECT_NEAR(glm::distance(at, p), chain.link, 1e-9);
    at = p;
  }
}

TEST(Hang, StiffnessIsTheLengthThatStandsOut) {
  TriangleSurface host = nowhere();
  // Bending of a level rod under its own weight, by the theory of small bends: w L^4 / (8 E I).
  Chain stiff = grown(host, 2, 20, DVec3(1, 0, 0));
  double length = stiff.length(), sag = stiff.root.y - stiff.place.back().y;
  EXPECT_NEAR(sag / (std::pow(length, 4) / 8 / std::pow(2.0, 3)), 1, 0.35);
  // A long soft one hangs straight down but for its beginning.
  Chain soft = grown(host, 0.05, 60, DVec3(1, 0, 0));
  EXPECT_LT(soft.place.back().x - soft.root.x, 0.12);
  EXPECT_GT(soft.root.y - soft.place.back().y, 1.2 - 0.12);
  // What stands up and is long falls over.
  Chain up = grown(host, 0.1, 50, DVec3(0, 1, 0));
  EXPECT_LT(up.place.back().y, up.root.y);
}

TEST(Hang, IsAtRest) {
  TriangleSurface host = nowhere();
  Chain chain = grown(host, 0.1, 40, DVec3(1, 0.3, 0.2));
  EXPECT_LT(settle(chain, host, 1), 1e-4);
}

TEST(Hang, DrapesOverALedgeWithoutCuttingIt) {
  TriangleSurface host = built(cube(1, 4));
  Chain chain = grown(host, 0.06, 40, DVec3(1, 0, 0), DVec3(0.4, 1.003, 0.1));
  DVec3 at = chain.root;
  for (const DVec3& p : chain.place) {
    EXPECT_FALSE(host.inside(p));
    EXPECT_FALSE(host.crossing(at, p));
    EXPECT_NEAR(glm::distance(at, p), chain.link, 1e-9);
    at = p;
  }
  EXPECT_LT(chain.place.back().y, 0.5);
}

Strands hanging_garden(const TriangleSurface& host) {
  Crawl crawl;
  crawl.let_go = 0.6;
  return grow_strands(host, starts_at_foot(host, 12, 0.05, Vec3(0, 0, 1), Seed{2}), crawl, Seed{5});
}

TEST(Hang, OnlyWhatIsMarkedHangsAndItKeepsItsLength) {
  TriangleSurface host = built(wall_with_openings());
  Strands s = hanging_garden(host);
  std::size_t hung = 0, gripped = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (!s.hanging[i]) continue;
    ++hung;
    std::int32_t p = s.skeleton.parent[i];
    ASSERT_GE(p, 0);
    if (s.hanging[p]) {
      EXPECT_NEAR(glm::distance(s.skeleton.position[i], s.skeleton.position[p]), 0.02, 2e-4);
    }
    gripped +=
        i + 1 < s.size() && s.skeleton.parent[i + 1] == static_cast<std::int32_t>(i) && !s.hanging[i + 1];
    EXPECT_FALSE(host.inside(DVec3(s.skeleton.position[i])));
  }
  EXPECT_GT(hung, 500u);
  EXPECT_GT(gripped, 3u);
}

/// A ball of 1 m without the faces near some places.
Surface ball_with_holes(double hole) {
  Surface whole = ball(1, 64, 48), s = whole;
  s.triangle.clear();
  for (auto t : whole.triangle) {
    Vec3 middle = glm::normalize(whole.position[t[0]] + whole.position[t[1]] + whole.position[t[2]]);
    bool missing = false;
    for (Vec3 at : {Vec3(0, 1, 0.4f), Vec3(0.7f, 0.7f, 0.5f), Vec3(-0.6f, 0.5f, 0.7f), Vec3(0.1f, 0.1f, 1)})
      missing |= glm::distance(middle, glm::normalize(at)) < hole;
    if (!missing) s.triangle.push_back(t);
  }
  return s;
}

/// A front of a house as a scan from the street gives it: a sheet with sills and windows without panes.
Surface front_of_a_house() {
  Surface whole = sheet(80, 60, false, false, [](double u, double v) {
    return Vec3(4 * u - 2, 3 * v, 0.06 * std::sin(9 * u) + (std::fmod(v, 0.34) > 0.28 ? 0.12 : 0.0));
  });
  Surface s = whole;
  s.triangle.clear();
  for (auto t : whole.triangle) {
    Vec3 at = whole.position[t[0]];
    float x = std::fmod(at.x + 2.0f, 1.0f), y = std::fmod(at.y, 1.02f);
    if (!(x > 0.35f && x < 0.65f && y > 0.3f && y < 0.8f)) s.triangle.push_back(t);
  }
  set_normals(s);
  return s;
}

TEST(Hang, NothingSlipsInThroughTheHolesOfAScan) {
  struct Case {
    const char* name;
    Surface surface;
    double least;  // winding number of what is behind
  };
  for (auto& [name, surface, least] :
       {Case{"ball", ball_with_holes(0.12), 0.7}, Case{"large holes", ball_with_holes(0.35), 0.7},
        Case{"scan", scanned(Seed{3}), 0.7}, Case{"front", front_of_a_house(), 0.45}}) {
    SCOPED_TRACE(name);
    TriangleSurface host = built(surface);
    ASSERT_FALSE(host.closed());
    Crawl crawl;
    crawl.let_go = 0.6;
    crawl.max_age = 120;
    double above = 0.3 * (host.high().y - host.low().y);
    Strands s = grow_strands(host, starts_at_foot(host, 8, above, Vec3(0), Seed{2}), crawl, Seed{5});
    std::size_t hung = 0, behind = 0, across = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
      if (!s.hanging[i]) continue;
      ++hung;
      DVec3 at(s.skeleton.position[i]);
      behind += winding(host, at) > least;
      std::int32_t below = s.skeleton.parent[i];
      across += s.hanging[below] && host.crossing(DVec3(s.skeleton.position[below]), at);
    }
    printf("%s: %zu of %zu hanging nodes behind, %zu across\n", name, behind, hung, across);
    EXPECT_GT(hung, 100u);
    EXPECT_LE(behind, hung / 500);
    EXPECT_EQ(across, 0u);
  }
}

TEST(Swing, IsAFunctionOfTimeThatRepeatsAndKeepsLengths) {
  TriangleSurface host = built(wall_with_openings());
  Strands s = hanging_garden(host);
  Breeze breeze;
  breeze.film_length = 6;
  std::vector<Vec3> first, at, later, again;
  std::vector<Quat> turn;
  swing_strands(s, breeze, 0, first, turn);
  swing_strands(s, breeze, 6, again, turn);
  swing_strands(s, breeze, 1.7, at, turn);
  swing_strands(s, breeze, 1.7 + 1.0 / 25, later, turn);
  double widest = 0, fastest = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    EXPECT_LT(glm::distance(first[i], again[i]), 1e-4f);
    if (!s.hanging[i]) {
      EXPECT_EQ(at[i], s.skeleton.position[i]);
      continue;
    }
    std::int32_t p = s.skeleton.parent[i];
    EXPECT_NEAR(glm::distance(at[i], at[p]), glm::distance(s.skeleton.position[i], s.skeleton.position[p]),
                1e-5);
    EXPECT_LE(glm::distance(at[i], s.skeleton.position[i]), s.room[i] + 1e-4) << i;
    EXPECT_FALSE(host.inside(DVec3(at[i])));
    widest = std::max<double>(widest, glm::distance(at[i], s.skeleton.position[i]));
    fastest = std::max<double>(fastest, glm::distance(at[i], later[i]));
  }
  EXPECT_GT(widest, 0.04);
  EXPECT_LT(fastest, 0.05);
}

}  // namespace
}  // namespace frond
