#include "creeping/tendrils.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "creeping/meshes.h"
#include "creeping/tendril_lines.h"

namespace frond {
namespace {

/// A closed round bar, of `sides` faces.
Surface bar(Vec3 from, Vec3 to, float radius, int sides = 24) {
  Vec3 along = glm::normalize(to - from);
  Vec3 one = glm::normalize(glm::cross(along, reference_axis(along))), other = glm::cross(along, one);
  constexpr int kRows = 12;
  return sheet(sides, kRows, true, false, [=](double u, double v) {
    auto row = static_cast<int>(std::lround(v * kRows));
    float wide = row == 0 || row == kRows ? 0 : radius;
    float share = static_cast<float>(std::clamp(row - 1, 0, kRows - 2)) / (kRows - 2);
    double a = 2 * kPi * u;
    return glm::mix(from, to, share) + wide * (float(std::cos(a)) * one - float(std::sin(a)) * other);
  });
}

void add_to(Surface& all, const Surface& more) {
  auto first = static_cast<std::uint32_t>(all.position.size());
  all.position.insert(all.position.end(), more.position.begin(), more.position.end());
  for (auto [a, b, c] : more.triangle) all.triangle.push_back({a + first, b + first, c + first});
}

/// Canes 0.16 m apart and level wires, as of a net.
Surface net() {
  Surface all;
  for (float x : {-0.32f, -0.16f, 0.0f, 0.16f, 0.32f})
    add_to(all, bar(Vec3(x, 0, 0), Vec3(x, 1.2f, 0), 0.006f));
  for (float y = 0.13f; y < 1.1f; y += 0.13f)
    add_to(all, bar(Vec3(-0.4f, y, 0.012f), Vec3(0.4f, y, 0.012f), 0.002f));
  set_normals(all);
  return all;
}

Tendrils vine() {
  Tendrils tendrils;
  tendrils.reach = 0.15, tendrils.behind = 0.03;
  return tendrils;
}

constexpr double kTime = 0.08;

struct Climber {
  Strands before, strands;
  std::vector<TendrilSite> sites;
  std::vector<TendrilRun> runs;

  /// The node that bears a run, of a branch that of its tendril.
  std::int32_t bearer(const TendrilRun& run) const {
    std::int32_t node = run.first;
    while (node >= static_cast<std::int32_t>(before.size())) node = strands.skeleton.parent[node];
    return node;
  }
  int count(TendrilState state) const {
    return static_cast<int>(std::ranges::count_if(
        runs, [&](const TendrilRun& run) { return run.state == state && !run.branch; }));
  }
};

Climber climber(const TriangleSurface& host, const std::vector<Start>& starts, const Tendrils& tendrils,
                std::uint64_t seed = 1) {
  Crawl crawl;
  crawl.speed = 0.01, crawl.max_age = 90, crawl.bias = {0.9}, crawl.wander = 0.05, crawl.branch_depth = 0;
  crawl.radius = 0.002, crawl.pipe = 0, crawl.spacing = 0, crawl.let_go = 0;
  Climber c;
  c.before = grow_strands(host, starts, crawl, Seed{1});
  c.strands = c.before;
  for (std::int32_t i = 5; i < static_cast<std::int32_t>(c.before.size()); i += 5)
    c.sites.push_back({i, Vec3(i % 2 ? 1 : -1, 0, 0)});
  c.runs = add_tendrils(c.strands, host, c.sites, tendrils, kTime, Seed{seed});
  return c;
}

std::vector<Start> at_canes() {
  std::vector<Start> starts;
  for (int i = -2; i <= 2; ++i) starts.push_back({.place = DVec3(0.16 * i, 0.05, 0.01)});
  return starts;
}

/// No node of a tendril is in the host deeper than its radius, and none of them goes through it.
void expect_outside(const Climber& c, const TriangleSurface& host) {
  ASSERT_EQ(c.strands.skeleton.find_fault(), "");
  const Skeleton& s = c.strands.skeleton;
  std::size_t deep = 0, through = 0;
  for (std::size_t i = c.before.size(); i < s.size(); ++i) {
    DVec3 at(s.position[i]), from(s.position[s.parent[i]]);
    deep += host.inside(at) && host.closest(at)->distance > s.radius[i];
    // Only a pad goes into it.
    through += s.radius[i] < 0.0015f && host.crossing(from, at);
  }
  EXPECT_EQ(deep, 0u);
  EXPECT_EQ(through, 0u);
}

TEST(Tendrils, WindRoundWhatIsThinAndLieOnIt) {
  TriangleSurface host = built(net());
  Climber c = climber(host, at_canes(), vine());
  expect_outside(c, host);
  EXPECT_GT(c.count(TendrilState::wound), 30);
  EXPECT_EQ(c.count(TendrilState::padded), 0);
  const Skeleton& s = c.strands.skeleton;
  for (const TendrilRun& run : c.runs) {
    if (run.state != TendrilState::wound) continue;
    std::int32_t last = run.first + run.count - 1;
    EXPECT_NEAR(host.closest(DVec3(s.position[last]))->distance, s.radius[last], 2e-5);
    EXPECT_LT(glm::distance(s.position[run.first], s.position[c.bearer(run)]), 0.02f);
  }
}

TEST(Tendrils, EndInPadsOnWalls) {
  TriangleSurface host = built(thin_wall());
  Tendrils tendrils = vine();
  tendrils.pads = true, tendrils.reach = 0.06, tendrils.coils = 1, tendrils.coil = 0.001;
  Climber c = climber(host, starts_at_foot(host, 6, 0.05, Vec3(0, 0, 1), Seed{2}), tendrils);
  expect_outside(c, host);
  EXPECT_GT(c.count(TendrilState::padded), 40);
  EXPECT_EQ(c.count(TendrilState::wound), 0);
  const Skeleton& s = c.strands.skeleton;
  int pads = 0;
  for (const TendrilRun& run : c.runs) {
    if (!run.branch) continue;
    ++pads;
    std::int32_t last = run.first + run.count - 1;
    // A disc: a ball sunk into the wall by half, on which the last piece stands straight.
    std::optional<Contact> near = host.closest(DVec3(s.position[last]));
    ASSERT_TRUE(near->inside);
    double seen = std::sqrt(s.radius[last] * s.radius[last] - near->distance * near->distance);
    EXPECT_NEAR(seen, 0.0015, 0.0001);
    EXPECT_LT(s.radius[last] - near->distance, 0.7 * 0.0015);
    Vec3 down = glm::normalize(s.position[last] - s.position[last - 1]);
    EXPECT_LT(glm::dot(down, Vec3(near->normal)), -0.99f);
  }
  EXPECT_GT(pads, 3 * c.count(TendrilState::padded));
}

TEST(Tendrils, StayFreeWhereNothingIsThinOrNear) {
  TriangleSurface host = built(thin_wall());
  Climber c = climber(host, starts_at_foot(host, 6, 0.05, Vec3(0, 0, 1), Seed{2}), vine());
  expect_outside(c, host);
  EXPECT_EQ(c.count(TendrilState::wound) + c.count(TendrilState::padded), 0);
  EXPECT_GT(c.count(TendrilState::free), 20);
  Tendrils none = vine();
  none.waste = 0;
  c = climber(host, starts_at_foot(host, 6, 0.05, Vec3(0, 0, 1), Seed{2}), none);
  EXPECT_EQ(c.count(TendrilState::free), 0);
}

TEST(Tendrils, AreBornAfterTheirNodesAndCoilWithAge) {
  TriangleSurface host = built(net());
  Climber c = climber(host, at_canes(), vine());
  const Skeleton& s = c.strands.skeleton;
  double young = 0, old = 0;  // how much longer than its chord a free part is, at most
  for (const TendrilRun& run : c.runs) {
    std::int32_t node = c.bearer(run);
    float born = s.birth[node], length = 0, farthest = 0;
    for (std::int32_t i = run.first; i < run.first + run.count; ++i) {
      EXPECT_GE(s.birth[i], s.birth[s.parent[i]]);
      EXPECT_LE(s.birth[i], 1.0f);
      length += glm::distance(s.position[i], s.position[s.parent[i]]);
      farthest = std::max(farthest, glm::distance(s.position[i], s.position[node]));
    }
    if (run.state == TendrilState::young) {
      EXPECT_GT(born, 1 - kTime);
      young = std::max<double>(young, length / farthest);
    } else {
      EXPECT_LE(born, 1 - kTime + 1e-6);
      EXPECT_GT(s.birth[run.first + run.count - 1], born + 0.99 * kTime);
      old = std::max<double>(old, length / farthest);
    }
  }
  EXPECT_GT(c.count(TendrilState::young), 2);
  EXPECT_LT(young, 1.1);
  EXPECT_GT(old, 1.8);
}

TEST(Tendrils, ChangeNothingOfTheirStrands) {
  TriangleSurface host = built(net());
  Climber c = climber(host, at_canes(), vine());
  const Skeleton &s = c.strands.skeleton, &b = c.before.skeleton;
  ASSERT_GT(s.size(), b.size());
  for (std::size_t i = 0; i < b.size(); ++i) {
    EXPECT_EQ(s.position[i], b.position[i]);
    EXPECT_EQ(s.birth[i], b.birth[i]);
    EXPECT_EQ(s.to_tip[i], b.to_tip[i]);
  }
  for (std::size_t n : {c.strands.normal.size(), c.strands.contact.size(), c.strands.age.size(),
                        c.strands.hanging.size(), c.strands.room.size(), c.strands.of.size()})
    EXPECT_EQ(n, s.size());
  for (const TendrilRun& run : c.runs) EXPECT_GE(b.to_tip[c.bearer(run)], 0.03f) << "none near a tip";
  Strands same = c.before;
  EXPECT_TRUE(add_tendrils(same, host, {}, vine(), kTime, Seed{1}).empty());
  EXPECT_EQ(same.size(), b.size());
}

TEST(Tendrils, AreTheSameOnAnyNumberOfThreads) {
  TriangleSurface host = built(net());
  limit_threads(1);
  Climber one = climber(host, at_canes(), vine());
  limit_threads(3);
  Climber three = climber(host, at_canes(), vine()), other = climber(host, at_canes(), vine(), 2);
  limit_threads(0);
  EXPECT_EQ(one.strands.skeleton.position, three.strands.skeleton.position);
  EXPECT_NE(one.strands.skeleton.position, other.strands.skeleton.position);
}

TEST(Tendrils, KeepOutOfTheGround) {
  TriangleSurface host = built(net());
  Strands strands = climber(host, at_canes(), vine()).before;
  std::vector<TendrilSite> sites;
  for (std::int32_t i = 5; i < static_cast<std::int32_t>(strands.size()); i += 5)
    sites.push_back({i, Vec3(1, -1, 0)});
  auto first = strands.size();
  GroundHeight ground = [](double, double) { return 0.3; };
  add_tendrils(strands, host, sites, vine(), kTime, Seed{1}, ground);
  ASSERT_GT(strands.size(), first);
  for (std::size_t i = first; i < strands.size(); ++i) EXPECT_GT(strands.skeleton.position[i].y, 0.3f);
}

/// How far a line turns about an axis, to the left, between two of its places; turns.
double winding(const std::vector<DVec3>& line, std::size_t from, std::size_t to, const DVec3& middle,
               const DVec3& axis) {
  double sum = 0;
  auto off = [&](std::size_t i) {
    DVec3 d = line[i] - middle;
    return d - glm::dot(d, axis) * axis;
  };
  for (std::size_t i = from; i < to; ++i) {
    DVec3 a = off(i), b = off(i + 1);
    if (glm::length(a) < 1e-6 || glm::length(b) < 1e-6) continue;
    sum += std::atan2(glm::dot(glm::cross(a, b), axis), glm::dot(a, b));
  }
  return sum / (2 * kPi);
}

TEST(CoiledLine, HasAsManyTurnsToEitherHand) {
  DVec3 from(0.3, 0, 0), to(0.3, 0.1, 0.02), axis = glm::normalize(to - from);
  for (double coils : {2.0, 5.0}) {
    std::vector<DVec3> line = coiled_line(from, 0.5 * (from + to), to, coils, 0.003);
    EXPECT_EQ(line.front(), from);
    EXPECT_LT(glm::distance(line.back(), to), 1e-12);
    std::size_t middle = line.size() / 2, last = line.size() - 1;
    double first = winding(line, 0, middle, from, axis), second = winding(line, middle, last, from, axis);
    EXPECT_NEAR(std::abs(first), coils, 0.12 * coils);
    EXPECT_NEAR(first + second, 0, 0.1);
  }
  std::vector<DVec3> straight = coiled_line(from, 0.5 * (from + to), to, 5, 0);
  for (const DVec3& at : straight) EXPECT_LT(glm::length(glm::cross(at - from, axis)), 1e-12);
}

TEST(PoleAt, FindsWhatIsThinAndItsAxis) {
  DVec3 axis = glm::normalize(DVec3(1, 2, 0.5));
  TriangleSurface host = built(bar(Vec3(0), Vec3(2.0 * axis), 0.008f, 48));
  DVec3 out = glm::normalize(glm::cross(axis, DVec3(0, 0, 1)));
  std::optional<Contact> near = host.closest(axis + 0.05 * out);
  std::optional<Pole> pole = pole_at(host, near->point, near->normal, 0.03);
  ASSERT_TRUE(pole);
  EXPECT_NEAR(pole->half, 0.008, 0.0003);
  EXPECT_GT(glm::dot(pole->axis, axis), 0.999);
  EXPECT_LT(glm::length(glm::cross(pole->middle, axis)), 0.0005);
  EXPECT_FALSE(pole_at(host, near->point, near->normal, 0.012)) << "thicker than that";
  TriangleSurface wall = built(thin_wall());
  EXPECT_FALSE(pole_at(wall, DVec3(0, 1, 0.15), DVec3(0, 0, 1), 0.1));
  EXPECT_FALSE(pole_at(wall, DVec3(0, 1, 0.15), DVec3(0, 0, 1), 0.35)) << "thin, but wide";
}

TEST(WoundLine, GoesRoundASquareLathByItsHand) {
  // 24 by 24 mm.
  TriangleSurface host =
      built(bricks(1, 20, 1, Vec3(0.024f, 0.05f, 0.024f), [](int, int, int) { return true; }));
  Pole pole{DVec3(0, 0.5, 0), DVec3(0, 1, 0), 0.012};
  for (double hand : {1.0, -1.0}) {
    std::vector<DVec3> line = wound_line(host, pole, DVec3(0.1, 0.5, 0.03), 3, 0.0005, 0.002, hand);
    ASSERT_GT(line.size(), 30u);
    EXPECT_NEAR(hand * winding(line, 0, line.size() - 1, pole.middle, pole.axis), 3, 0.1);
    EXPECT_NEAR(line.back().y - line.front().y, 0.006, 1e-6);
    for (std::size_t i = 0; i < line.size(); ++i) {
      EXPECT_NEAR(host.closest(line[i])->distance, 0.0005, 1e-8);
      EXPECT_FALSE(host.crossing(line[i > 0 ? i - 1 : 0], line[i]));
    }
  }
  EXPECT_TRUE(wound_line(host, pole, DVec3(0.013, 0.5, 0), 3, 0.0005, 0.002, 1).empty()) << "too near";
}

}  // namespace
}  // namespace frond
