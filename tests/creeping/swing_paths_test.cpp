#include "creeping/swing_paths.h"

#include <gtest/gtest.h>

#include <utility>

#include "core/parallel.h"
#include "creeping/hung_chain.h"
#include "creeping/meshes.h"

namespace frond {
namespace {

/// Hangs straight down from a point, without any clamp.
HungStrand straight(double length, int links, double stiffness) {
  HungStrand strand;
  strand.stiffness = stiffness;
  for (int i = 1; i <= links; ++i) strand.place.emplace_back(0, -length * i / links, 0);
  return strand;
}

/// Seconds of the slowest swing after a puff of air.
double period_of(HungStrand strand) {
  constexpr double step = 1.0 / 480;
  HungChain chain(std::move(strand), step);
  for (int s = 0; s < 100; ++s) chain.advance(DVec3(0.4, 0, 0));
  for (int s = 0; s < 960; ++s) chain.advance(DVec3(0));
  std::vector<double> through;  // times at which the end comes back to the middle
  double last = chain.places().back().x;
  for (int s = 0; s < 9600; ++s) {
    chain.advance(DVec3(0));
    double now = chain.places().back().x;
    if (last < 0 && now >= 0) through.push_back(step * (s - now / (now - last)));
    last = now;
  }
  return (through.back() - through.front()) / static_cast<double>(through.size() - 1);
}

TEST(HungChain, SwingsAsAHeavyChain) {
  // Bernoulli (1738): the slowest mode of a chain without stiffness, 1.2024 sqrt(g / L).
  for (double length : {0.3, 1.0, 3.0})
    EXPECT_NEAR(period_of(straight(length, 50, 1e-3)) * 1.2024 / (2 * kPi) * std::sqrt(9.81 / length), 1,
                0.02)
        << length;
}

TEST(HungChain, SwingsAsARodWhereItIsStiff) {
  for (double length : {0.3, 1.0})
    EXPECT_NEAR(period_of(straight(length, 30, 20)) / (2 * kPi * std::sqrt(2 * length / (3 * 9.81))), 1, 0.02)
        << length;
  // Clamped, it vibrates as a cantilever does: 3.516 sqrt(E I / (w L^4)), E I / w being the cube of the
  // stiffness times g.
  HungStrand clamped = straight(1, 30, 3);
  clamped.heading = DVec3(0, -1, 0);
  EXPECT_NEAR(period_of(clamped) * 3.516 * std::sqrt(27 * 9.81) / (2 * kPi), 1, 0.03);
}

TEST(HungChain, KeepsLengthsAndRoomInAnyWind) {
  for (bool bridged : {false, true})
    for (double stiffness : {0.001, 0.12, 3.0}) {
      HungStrand strand;
      strand.stiffness = stiffness;
      strand.heading = DVec3(1, 0, 0);
      for (int i = 1; i <= 40; ++i) {
        strand.place.emplace_back(0.015 * i, bridged ? 0.0004 * i * (i - 41) : -0.0004 * i * i, 0);
        strand.room.push_back(i == 20 ? 0.01 : 10);
      }
      if (bridged) strand.end = DVec3(0.015 * 41, 0, 0);
      std::vector<DVec3> rest = strand.place;
      HungChain chain(strand, 1.0 / 240);
      double moved = 0;
      for (int s = 0; s < 2400; ++s) {
        chain.advance(DVec3(6 * std::sin(0.02 * s), 4 * std::sin(0.011 * s), 8 * std::sin(0.013 * s)));
        DVec3 above = strand.root, above_rest = strand.root;
        for (std::size_t i = 0; i < rest.size(); ++i) {
          const DVec3& at = chain.places()[i];
          ASSERT_NEAR(glm::distance(at, above) / glm::distance(rest[i], above_rest), 1, 0.02)
              << s << " " << i;
          above = at, above_rest = rest[i];
        }
        EXPECT_LT(glm::distance(chain.places()[19], rest[19]), 0.0105);
        moved = std::max(moved, glm::distance(chain.places()[30], rest[30]));
      }
      if (stiffness < 1) {
        EXPECT_GT(moved, 0.01);
      }
    }
}

TEST(HungChain, StaysAtRestWithoutWind) {
  HungStrand strand;
  strand.heading = DVec3(1, 0, 0);
  for (int i = 1; i <= 40; ++i)
    strand.place.emplace_back(0.3 * std::sin(0.05 * i), -0.01 * i, 0.02 * std::cos(0.3 * i));
  HungChain chain(strand, 1.0 / 240);
  for (int s = 0; s < 2400; ++s) chain.advance(DVec3(0));
  for (std::size_t i = 0; i < chain.size(); ++i)
    EXPECT_LT(glm::distance(chain.places()[i], strand.place[i]), 1e-9);
}

struct Garden {
  TriangleSurface host = built(wall_with_openings());
  Strands strands;
  Breeze breeze;
  Garden() {
    Crawl crawl;
    crawl.let_go = 0.6;
    strands = grow_strands(host, starts_at_foot(host, 12, 0.05, Vec3(0, 0, 1), Seed{2}), crawl, Seed{5});
    breeze.speed = 3;
    breeze.film_length = 6;
  }
};

TEST(SwingPaths, AreAFunctionOfTimeThatRepeatsAndKeepsLengths) {
  Garden g;
  SwingPaths paths = swing_paths(g.strands, g.breeze, 0.12);
  const Strands& s = g.strands;
  std::vector<Vec3> first, at, before, earlier, again;
  std::vector<Quat> turn;
  swing_strands(s, paths, 0, first, turn);
  swing_strands(s, paths, 6, again, turn);
  double widest = 0, fastest = 0, sharpest = 0, over = 0;
  for (int frame = 0; frame <= 150; ++frame) {
    swing_strands(s, paths, frame / 25.0, at, turn);
    for (std::size_t i = 0; i < s.size(); ++i) {
      std::int32_t p = s.skeleton.parent[i];
      double moved = glm::distance(at[i], s.skeleton.position[i]);
      if (!s.hanging[i]) {
        ASSERT_EQ(moved, 0);
        // Where a part is held at both ends, the last link of it.
        if (p < 0 || !s.hanging[p]) continue;
        ASSERT_NEAR(glm::distance(at[i], at[p]),
                    glm::distance(s.skeleton.position[i], s.skeleton.position[p]), 2e-3);
        continue;
      }
      ASSERT_NEAR(glm::distance(at[i], at[p]), glm::distance(s.skeleton.position[i], s.skeleton.position[p]),
                  1e-5);
      over = std::max(over, moved - s.room[i]);
      ASSERT_FALSE(g.host.inside(DVec3(at[i])));
      widest = std::max(widest, moved);
      if (frame < 2) continue;
      fastest = std::max<double>(fastest, glm::distance(at[i], before[i]));
      sharpest = std::max<double>(sharpest, glm::length(at[i] - 2.0f * before[i] + earlier[i]));
    }
    earlier = std::exchange(before, at);
  }
  for (std::size_t i = 0; i < s.size(); ++i) EXPECT_LT(glm::distance(first[i], again[i]), 1e-5f);
  EXPECT_LT(over, 1e-3);
  EXPECT_GT(widest, 0.1);
  EXPECT_LT(fastest, 0.1);
  EXPECT_LT(sharpest, 0.08);
}

TEST(SwingPaths, AreTheSameOnAnyNumberOfThreads) {
  Garden g;
  SwingPaths many = swing_paths(g.strands, g.breeze, 0.12);
  limit_threads(1);
  SwingPaths one = swing_paths(g.strands, g.breeze, 0.12);
  limit_threads(0);
  EXPECT_EQ(many.tilt, one.tilt);
}

TEST(SwingPaths, OfAStillAreOneMoment) {
  Garden g;
  g.breeze.film_length = 0;
  SwingPaths paths = swing_paths(g.strands, g.breeze, 0.12);
  EXPECT_EQ(paths.tilt.size(), paths.node.size());
  g.breeze.film_length = 100;
  EXPECT_EQ(swing_paths(g.strands, g.breeze, 0.12).steps, 480) << "long films repeat it";
}

}  // namespace
}  // namespace frond
