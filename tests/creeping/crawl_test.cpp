#include "creeping/crawl.h"

#include <gtest/gtest.h>

#include "core/parallel.h"
#include "creeping/meshes.h"

namespace frond {
namespace {

/// What is wrong with strands on a host: too far from it, within it, through it deeper than they are thick.
struct Faults {
  std::size_t far = 0, floating = 0, within = 0, through = 0;
};

Faults faults(const Strands& s, const TriangleSurface& host) {
  Faults f;
  for (std::size_t i = 0; i < s.size(); ++i) {
    DVec3 at(s.skeleton.position[i]);
    double off = host.closest(at)->distance, radius = s.skeleton.radius[i];
    if (!s.hanging[i]) {
      f.far += off > radius + 0.01 * host.size();
      f.floating += off > 1.2 * radius + 1e-6 * host.size();
    }
    f.within += host.inside(at);
    std::int32_t p = s.skeleton.parent[i];
    if (p < 0) continue;
    DVec3 from(s.skeleton.position[p]);
    auto in = host.crossing(from, at);
    if (!in) continue;
    auto out = host.crossing(at, from);
    DVec3 a = from + (at - from) * in->share, b = out ? at + (from - at) * out->share : at;
    double deepest = 0;
    for (int k = 0; k <= 10; ++k)
      deepest = std::max(deepest, host.closest(a + (b - a) * (k / 10.0))->distance);
    f.through += deepest > std::max<double>(radius, s.skeleton.radius[p]);
  }
  return f;
}

void expect_on(const TriangleSurface& host, const Strands& s) {
  ASSERT_EQ(s.skeleton.find_fault(), "");
  Faults f = faults(s, host);
  EXPECT_EQ(f.far, 0u);
  EXPECT_EQ(f.floating, 0u);
  EXPECT_EQ(f.within, 0u);
  EXPECT_EQ(f.through, 0u);
}

TEST(Crawl, KeepsToEverySurface) {
  struct Case {
    const char* name;
    Surface surface;
  };
  for (const Case& c : {Case{"ball", ball(1, 160, 80)},
                        {"ring", ring(1, 0.3, 160, 80)},
                        {"cube", cube(1, 10)},
                        {"rock", bumpy_rock()},
                        {"thin wall", thin_wall()},
                        {"openings", wall_with_openings()},
                        {"corner", corner()}}) {
    SCOPED_TRACE(c.name);
    TriangleSurface host = built(c.surface);
    Strands s = grow_strands(host, starts_around(host, 12, Vec3(0), 10, Seed{3}), {}, Seed{1});
    EXPECT_GT(s.size(), 3000u);
    expect_on(host, s);
  }
}

TEST(Crawl, TwinesUpAPoleInAHelixOfItsPitchAndHand) {
  constexpr double kRadius = 0.04;
  TriangleSurface pole = built(sheet(64, 120, true, false, [](double u, double v) {
    double a = 2 * kPi * u;
    return Vec3(kRadius * std::cos(a), 2.4 * v, -kRadius * std::sin(a));
  }));
  for (double pitch : {radians(62.0), radians(-35.0)}) {
    Crawl crawl;
    crawl.lure = Lure::round, crawl.pitch = pitch, crawl.bias = {0.9};
    crawl.speed = 0.005, crawl.wander = 0, crawl.branch_depth = 0, crawl.spacing = 0, crawl.max_age = 300;
    Strands s = grow_strands(pole, {{.place = DVec3(kRadius, 0.1, 0)}}, crawl, Seed{1});
    ASSERT_EQ(s.strands.size(), 1u);
    double wound = 0;  // radians about +y, by the right-hand rule
    const std::vector<Vec3>& at = s.skeleton.position;
    std::size_t first = at.size() / 8;
    for (std::size_t i = first + 1; i < at.size(); ++i)
      wound += std::atan2(at[i - 1].z * at[i].x - at[i - 1].x * at[i].z,
                          at[i - 1].x * at[i].x + at[i - 1].z * at[i].z);
    double rise = static_cast<double>(at.back().y - at[first].y);
    EXPECT_NEAR(wound, rise / std::tan(pitch) / kRadius, 0.04 * std::abs(wound));
    EXPECT_GT(std::abs(wound), 2 * kPi);
  }
}

TEST(Crawl, KeepsToWhatScannersGive) {
  for (std::uint64_t i = 0; i < 3; ++i) {
    TriangleSurface host = built(scanned(Seed{i}));
    Strands s = grow_strands(host, starts_at_foot(host, 12, 0.03, Vec3(0), Seed{3}), {}, Seed{i});
    EXPECT_GT(s.size(), 3000u);
    ASSERT_EQ(s.skeleton.find_fault(), "");
    Faults f = faults(s, host);
    EXPECT_EQ(f.far, 0u);
    EXPECT_EQ(f.through, 0u);
  }
}

TEST(Crawl, KeepsToTheOuterSideOfOpenMeshes) {
  Surface bowl = ball(1, 80, 40);
  std::erase_if(bowl.triangle, [&](const auto& t) { return bowl.position[t[0]].y > 0.3f; });
  TriangleSurface host = built(bowl);
  Crawl crawl;
  crawl.let_go = 0;
  auto within = [&](const Strands& s) {
    std::size_t count = 0;
    for (const Vec3& p : s.skeleton.position) count += glm::length(p) < 0.99f && p.y < 0.25f;
    return count;
  };
  auto starts = starts_at_foot(host, 12, 0.3, Vec3(0), Seed{3});
  Strands outer = grow_strands(host, starts, crawl, Seed{1});
  EXPECT_GT(outer.size(), 3000u);
  EXPECT_EQ(within(outer), 0u);
  crawl.backs = true;
  EXPECT_GT(within(grow_strands(host, starts, crawl, Seed{1})), 100u);
}

TEST(Crawl, IsTheSameAtAnyNumberOfThreads) {
  TriangleSurface host = built(bumpy_rock(5));
  auto starts = starts_at_foot(host, 20, 0.02, Vec3(0), Seed{3});
  limit_threads(1);
  Strands one = grow_strands(host, starts, {}, Seed{2});
  limit_threads(0);
  Strands many = grow_strands(host, starts, {}, Seed{2});
  EXPECT_EQ(one.skeleton.position, many.skeleton.position);
  EXPECT_EQ(one.skeleton.radius, many.skeleton.radius);
  EXPECT_EQ(one.skeleton.parent, many.skeleton.parent);
  EXPECT_EQ(one.skeleton.birth, many.skeleton.birth);
  EXPECT_EQ(one.hanging, many.hanging);
  Strands other = grow_strands(host, starts, {}, Seed{3});
  EXPECT_NE(one.skeleton.position, other.skeleton.position);
}

TEST(Crawl, GoesOverTheEdgesOfAThinWall) {
  TriangleSurface host = built(thin_wall());
  std::size_t reached = 0, over = 0, front = 0, back = 0;
  for (std::uint64_t i = 0; i < 4; ++i) {
    Strands s = grow_strands(host, starts_at_foot(host, 12, 0.05, Vec3(0, 0, 1), Seed{i}), {}, Seed{i});
    for (const Strand& strand : s.strands) {
      // Of those that come up the front to less than a step from an edge.
      bool at_edge = false, beyond = false;
      for (std::int32_t k = strand.first; k < strand.first + strand.count; ++k) {
        Vec3 p = s.skeleton.position[k], n = s.normal[k];
        if (s.hanging[k]) continue;
        at_edge |= n.z > 0.9f && (p.y > 1.98f || std::abs(p.x) > 1.98f);
        beyond |= at_edge && n.z < 0.5f;
      }
      reached += at_edge;
      over += beyond;
    }
    for (std::size_t k = 0; k < s.size(); ++k) {
      front += !s.hanging[k] && s.normal[k].z > 0.9f;
      back += !s.hanging[k] && s.normal[k].z < -0.9f;
    }
  }
  EXPECT_GT(reached, 50u);
  EXPECT_GT(static_cast<double>(over), 0.35 * static_cast<double>(reached)) << reached;
  EXPECT_GT(back, front / 4) << front;
  RecordProperty("share_over", static_cast<int>(100 * over / reached));
  RecordProperty("back_percent", static_cast<int>(100 * back / (front + back)));
}

/// The share of `cells` boxes all over the host's triangles that hold a node.
double covered(const TriangleSurface& host, const Strands& s, double near) {
  std::size_t all = 0, with = 0;
  for (const Start& spot : starts_around(host, 400, Vec3(0), 1e3, Seed{77})) {
    double best = near;
    for (const Vec3& p : s.skeleton.position) best = std::min(best, glm::distance(DVec3(p), spot.place));
    ++all;
    with += best < near;
  }
  return static_cast<double>(with) / static_cast<double>(all);
}

TEST(Crawl, GoesAllRoundABall) {
  TriangleSurface host = built(ball(1, 160, 80));
  Crawl crawl;
  crawl.branch_depth = 6;
  Strands s = grow_strands(host, {{DVec3(0, -1, 0), DVec3(1, 0, 0)}}, crawl, Seed{4});
  EXPECT_GT(covered(host, s, 0.2), 0.95);
  double low = 1, high = -1;
  for (const Vec3& p : s.skeleton.position) {
    low = std::min<double>(low, p.y);
    high = std::max<double>(high, p.y);
  }
  EXPECT_LT(low, -0.95);
  EXPECT_GT(high, 0.95);
}

TEST(Crawl, StrandsKeepApartAndFillAWallEvenly) {
  TriangleSurface host = built(bricks(40, 20, 3, Vec3(0.1f), [](int, int, int) { return true; }));
  auto starts = starts_at_foot(host, 12, 0.05, Vec3(0, 0, 1), Seed{1});
  Crawl crawl;
  crawl.let_go = 0;
  Strands apart = grow_strands(host, starts, crawl, Seed{1});
  crawl.spacing = 0;
  crawl.most_nodes = apart.size();
  Strands heap = grow_strands(host, starts, crawl, Seed{1});
  // How unevenly nodes lie over squares of 0.2 m of the front: deviation over mean.
  auto spread = [](const Strands& s) {
    std::vector<double> count(200, 0);
    for (std::size_t i = 0; i < s.size(); ++i) {
      Vec3 p = s.skeleton.position[i];
      if (s.normal[i].z < 0.9f || std::abs(p.x) >= 2 || p.y >= 2 || p.y < 0) continue;
      ++count[static_cast<int>((p.x + 2) / 0.2f) * 10 + static_cast<int>(p.y / 0.2f)];
    }
    double sum = 0, squares = 0;
    for (double c : count) sum += c, squares += c * c;
    double mean = sum / 200;
    return std::sqrt(squares / 200 - mean * mean) / mean;
  };
  EXPECT_LT(spread(apart), 0.5 * spread(heap));
  EXPECT_LT(spread(apart), 0.6);
  // Nodes of strands that do not branch off one another are hardly ever nearer than a third of the spacing.
  std::size_t close = 0, all = 0;
  for (std::size_t i = 0; i < apart.size(); i += 7) {
    if (apart.normal[i].z < 0.9f) continue;
    ++all;
    for (std::size_t k = 0; k < apart.size(); ++k) {
      std::int32_t a = apart.of[i], b = apart.of[k];
      if (a == b || apart.normal[k].z < 0.9f || apart.strands[a].parent == b || apart.strands[b].parent == a)
        continue;
      if (glm::distance(apart.skeleton.position[i], apart.skeleton.position[k]) >= 0.02f) continue;
      ++close;
      break;
    }
  }
  EXPECT_LT(static_cast<double>(close), 0.06 * static_cast<double>(all));
}

TEST(Crawl, BranchesToEitherSideAtTheAngle) {
  TriangleSurface host = built(bricks(1, 1, 1, Vec3(8, 8, 0.2f), [](int, int, int) { return true; }));
  Crawl crawl;
  crawl.wander = 0;
  crawl.bias = 0;
  crawl.spacing = 0;
  crawl.branch_depth = 1;
  crawl.branch_every = 0.3;
  crawl.branch_jitter = 0;
  crawl.max_age = 160;
  for (double angle : {radians(90.0), radians(40.0)}) {
    crawl.branch_angle = angle;
    Strands s = grow_strands(host, {{DVec3(0, 0.5, 0.1), DVec3(0, 1, 0)}}, crawl, Seed{1});
    std::size_t left = 0, right = 0;
    for (const Strand& strand : s.strands) {
      if (strand.parent < 0) continue;
      const auto& at = s.skeleton.position;
      // The first two own nodes: the very first may be lifted differently from its parent.
      Vec3 way = glm::normalize(at[strand.first + 1] - at[strand.first]);
      EXPECT_NEAR(way.y, std::cos(angle), 0.03);
      EXPECT_NEAR(std::abs(way.x), std::sin(angle), 0.03);
      ++(way.x < 0 ? left : right);
    }
    EXPECT_EQ(left + right, 10u);
    EXPECT_GT(left, 1u);
    EXPECT_GT(right, 1u);
  }
}

TEST(Crawl, StepsHaveTheirLengthAndFollowTheBias) {
  TriangleSurface host = built(bricks(1, 1, 1, Vec3(20, 20, 0.2f), [](int, int, int) { return true; }));
  Crawl crawl;
  crawl.branch_depth = 0;
  crawl.bias = 1;
  crawl.toward = Vec3(1, 1, 0);
  crawl.max_age = 200;
  Strands s = grow_strands(host, {{DVec3(-5, 5, 0.1), DVec3(0, -1, 0)}}, crawl, Seed{1});
  for (std::size_t i = 1; i < s.size(); ++i) {
    Vec3 way = s.skeleton.position[i] - s.skeleton.position[i - 1];
    way.z = 0;
    EXPECT_NEAR(glm::length(way), 0.02, 1e-4);
    EXPECT_NEAR(way.x, way.y, 1e-4);
  }
  EXPECT_EQ(s.size(), 201u);
  crawl.bias = 0;
  crawl.wander = 0;
  s = grow_strands(host, {{DVec3(-5, 5, 0.1), DVec3(3, 1, 0)}}, crawl, Seed{1});
  for (std::size_t i = 1; i < s.size(); ++i)
    EXPECT_NEAR(s.skeleton.position[i].y - 5, (s.skeleton.position[i].x + 5) / 3, 1e-4);
}

TEST(Crawl, BiasAndDirectionChangeWithTheGrowth) {
  TriangleSurface host = built(bricks(1, 1, 1, Vec3(20, 20, 0.2f), [](int, int, int) { return true; }));
  Crawl crawl;
  crawl.branch_depth = 0, crawl.wander = 0, crawl.max_age = 200;
  crawl.bias = Animated<double>({{0, 0.0}, {0.4, 0.0}, {0.5, 1.0}});
  crawl.toward = Animated<Vec3>({{0, Vec3(0, 1, 0)}, {0.7, Vec3(0, 1, 0)}, {0.75, Vec3(-1, 0, 0)}});
  Strands s = grow_strands(host, {{DVec3(-2, 3, 0.1), DVec3(1, 0, 0)}}, crawl, Seed{1});
  ASSERT_EQ(s.size(), 201u);
  auto way = [&](std::size_t i) { return (s.skeleton.position[i] - s.skeleton.position[i - 1]) / 0.02f; };
  for (std::size_t i = 1; i <= 80; ++i) EXPECT_NEAR(way(i).x, 1, 1e-2) << i;
  for (std::size_t i = 103; i <= 140; ++i) EXPECT_NEAR(way(i).y, 1, 1e-2) << i;
  for (std::size_t i = 153; i <= 200; ++i) EXPECT_NEAR(way(i).x, -1, 1e-2) << i;
}

/// Metres from a place to the nearest piece of a curve.
double away_from(const std::vector<DVec3>& curve, const DVec3& place) {
  double least = 1e9;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    DVec3 way = curve[i + 1] - curve[i];
    double share = std::clamp(glm::dot(place - curve[i], way) / glm::dot(way, way), 0.0, 1.0);
    least = std::min(least, glm::distance(place, curve[i] + share * way));
  }
  return least;
}

TEST(Crawl, StrandsKeepWithinTheWidthOfGuidesAndFillIt) {
  TriangleSurface host = built(bricks(1, 1, 1, Vec3(20, 20, 0.2f), [](int, int, int) { return true; }));
  // An S, drawn a little before the wall; its ends are far from each other along it and near in space.
  std::vector<DVec3> drawn, on_wall;
  for (int i = 0; i <= 60; ++i) {
    double t = i / 60.0, side = std::cos(1.5 * 2 * kPi * t);
    drawn.emplace_back(0.6 * side, 4 + 1.6 * t, 0.15);
    on_wall.emplace_back(drawn.back().x, drawn.back().y, 0.1);
  }
  Crawl crawl;
  crawl.guides.emplace_back().points = {drawn.begin(), drawn.end()};
  crawl.max_age = 900, crawl.branch_every = 0.15, crawl.spacing = 0.04, crawl.let_go = 0;
  for (std::uint64_t seed : {1u, 2u, 3u}) {
    Strands s = grow_strands(host, starts_on_guides(crawl.guides, 4), crawl, Seed{seed});
    ASSERT_GT(s.size(), 300u);
    for (const Vec3& at : s.skeleton.position) EXPECT_LT(away_from(on_wall, DVec3(at)), 0.125);
    for (const DVec3& at : on_wall) {
      double nearest = 1e9;
      for (const Vec3& node : s.skeleton.position)
        nearest = std::min(nearest, glm::distance(DVec3(node), at));
      EXPECT_LT(nearest, 0.12) << "nothing grows at " << at.x << ", " << at.y;
    }
  }
}

TEST(Crawl, GuidesLeadAsStronglyAsTheyPull) {
  TriangleSurface host = built(bricks(1, 1, 1, Vec3(20, 20, 0.2f), [](int, int, int) { return true; }));
  std::vector<DVec3> line{DVec3(0, 4, 0.1), DVec3(0, 9, 0.1)};
  Crawl crawl;
  crawl.guides.emplace_back().points = {line.begin(), line.end()};
  crawl.guides[0].width = 3;
  crawl.bias = 0, crawl.branch_depth = 0, crawl.spacing = 0, crawl.let_go = 0, crawl.max_age = 150;
  double last = 0;  // metres that they come along it
  for (double pull : {0.0, 0.1, 1.0}) {
    crawl.guides[0].pull = pull;
    double along = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      Start start{DVec3(0, 4, 0.1), DVec3(seed % 2 ? 1 : -1, 0, 0)};
      Strands s = grow_strands(host, {start}, crawl, Seed{seed});
      along += static_cast<double>(s.skeleton.position.back().y - 4) / 12;
    }
    if (pull > 0) {
      EXPECT_GT(along, last + 0.2) << pull;
    }
    last = along;
  }
}

TEST(Crawl, TipsWithoutATraceKeepApartAndTurnBack) {
  TriangleSurface host = built(ball(1, 160, 80));
  Crawl crawl;
  crawl.trace = false;
  crawl.bias = 0, crawl.spacing = 0.2, crawl.max_age = 300;
  crawl.low = Vec3(-2, -0.2f, -2);
  Strands s = grow_strands(host, starts_around(host, 24, Vec3(0, 1, 0), 1, Seed{1}), crawl, Seed{1});
  ASSERT_EQ(s.strands.size(), 24u);
  double walked = 0;
  for (const Strand& strand : s.strands) {
    EXPECT_EQ(strand.parent, -1);
    EXPECT_EQ(strand.end, End::age);
    std::int32_t last = strand.first + strand.count - 1;
    EXPECT_GT(s.skeleton.birth[last], 0.9f);
    walked += s.skeleton.distance[last];
  }
  EXPECT_GT(walked / 24, 0.7 * 300 * crawl.speed) << "they hardly stop";
  for (const Vec3& at : s.contact) EXPECT_GT(at.y, -0.25f);
  // At the same time none is beside another; their paths may cross.
  auto at = [&](std::size_t k, float time) {
    const Strand& path = s.strands[k];
    std::int32_t i = path.first;
    while (i + 1 < path.first + path.count && s.skeleton.birth[i + 1] <= time) ++i;
    return s.contact[i];
  };
  for (float time : {0.3f, 0.5f, 0.8f, 1.0f})
    for (std::size_t a = 0; a < s.strands.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) EXPECT_GT(glm::distance(at(a, time), at(b, time)), 0.05f);
}

TEST(Crawl, RadiiFollowAgeAndWhatIsCarried) {
  TriangleSurface host = built(thin_wall());
  Crawl crawl;
  crawl.pipe = 0;
  auto starts = starts_at_foot(host, 6, 0.05, Vec3(0, 0, 1), Seed{1});
  Strands s = grow_strands(host, starts, crawl, Seed{1});
  for (std::size_t i = 0; i < s.size(); ++i)
    EXPECT_FLOAT_EQ(s.skeleton.radius[i],
                    static_cast<float>(std::clamp(s.age[i] * 0.05, 0.1, 1.0) * crawl.radius));
  crawl.pipe = 2;
  crawl.thickest = 1000;
  s = grow_strands(host, starts, crawl, Seed{1});
  // Leonardo's rule where all is old: cross-sections of what leaves a node add up.
  std::vector<double> above(s.size(), 0);
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.skeleton.parent[i] >= 0) above[s.skeleton.parent[i]] += std::pow(s.skeleton.radius[i], 2);
  std::size_t old = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.age[i] < 60 || above[i] == 0) continue;
    EXPECT_NEAR(above[i] / std::pow(s.skeleton.radius[i], 2), 1, 0.02) << i;
    ++old;
  }
  EXPECT_GT(old, 1000u);
}

TEST(Crawl, StopsWhereItIsTold) {
  TriangleSurface host = built(thin_wall());
  auto starts = starts_at_foot(host, 6, 0.05, Vec3(0, 0, 1), Seed{1});
  Crawl crawl;
  crawl.max_length = 0.5;
  for (const Strands& s : {grow_strands(host, starts, crawl, Seed{1})})
    for (const Strand& strand : s.strands) EXPECT_LE(strand.count * 0.02, 0.75);
  crawl = {};
  crawl.low = Vec3(-1, 0, -1);
  crawl.high = Vec3(1, 1.2f, 1);
  starts = {{DVec3(0, 0.2, 0.15), DVec3(0)}};
  Strands s = grow_strands(host, starts, crawl, Seed{1});
  EXPECT_GT(s.size(), 300u);
  for (const Vec3& p : s.skeleton.position) {
    EXPECT_LE(p.y, 1.21f);
    EXPECT_LE(std::abs(p.x), 1.01f);
  }
  crawl = {};
  crawl.most_nodes = 777;
  EXPECT_LE(grow_strands(host, starts, crawl, Seed{1}).size(), 777u);
  crawl = {};
  crawl.max_age = 10;
  EXPECT_LE(grow_strands(host, starts, crawl, Seed{1}).skeleton.longest(), 0.21f);
  EXPECT_EQ(grow_strands(host, {}, crawl, Seed{1}).size(), 0u);
}

TEST(Crawl, DoesNotDependOnTheScale) {
  // A centimetre and a hundred metres, all lengths in proportion.
  std::vector<double> lengths;
  for (double scale : {0.01, 1.0, 100.0}) {
    Surface rock = bumpy_rock(5);
    for (Vec3& p : rock.position) p *= static_cast<float>(scale);
    TriangleSurface host = built(rock);
    Crawl crawl;
    for (double* metres : {&crawl.speed, &crawl.branch_every, &crawl.radius, &crawl.spacing, &crawl.hang_most,
                           &crawl.stiffness})
      *metres *= scale;
    Strands s = grow_strands(host, starts_at_foot(host, 12, 0.02 * scale, Vec3(0), Seed{1}), crawl, Seed{1});
    expect_on(host, s);
    double length = 0;
    for (std::size_t i = 0; i < s.size(); ++i)
      if (s.skeleton.parent[i] >= 0)
        length += glm::distance(s.skeleton.position[i], s.skeleton.position[s.skeleton.parent[i]]) / scale;
    lengths.push_back(length);
  }
  EXPECT_NEAR(lengths[0] / lengths[1], 1, 0.15);
  EXPECT_NEAR(lengths[2] / lengths[1], 1, 0.15);
}

}  // namespace
}  // namespace frond
