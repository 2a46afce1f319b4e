#include "foliage/inflorescence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foliage/floret_crowd.h"

namespace frond {
namespace {

constexpr InflorescenceType kTypes[] = {InflorescenceType::raceme,         InflorescenceType::spike,
                                        InflorescenceType::corymb,         InflorescenceType::umbel,
                                        InflorescenceType::compound_umbel, InflorescenceType::panicle,
                                        InflorescenceType::dichasium,      InflorescenceType::scorpioid,
                                        InflorescenceType::capitulum,      InflorescenceType::spadix};

constexpr Vec3 kDown(0, -1, 0);

/// A flower 12 mm across, or a bell of 30 mm.
constexpr auto open_flower = [](FloretRole, double) { return OrganRoom{0.002, 0.002, 0.006}; };
constexpr auto bell = [](FloretRole, double) { return OrganRoom{0.006, 0.024, 0.008}; };

Inflorescence of(InflorescenceType type, int flowers = 24) {
  Inflorescence p;
  p.type = type;
  p.flowers = flowers;
  p.flower = "W";
  p.bract = "B";
  return p;
}

std::size_t count(const LaidInflorescence& laid, FloretRole role) {
  return static_cast<std::size_t>(std::ranges::count(laid.florets, role, &LaidFloret::role));
}

TEST(Inflorescence, HasItsFlowersOnItsOwnStalks) {
  for (InflorescenceType type : kTypes)
    for (int flowers : {1, 2, 7, 40}) {
      LaidInflorescence laid = lay_inflorescence(of(type, flowers), 0, kDown, open_flower, Seed{3});
      EXPECT_EQ(count(laid, FloretRole::flower), static_cast<std::size_t>(flowers)) << static_cast<int>(type);
      for (std::size_t i = 0; i < laid.nodes.size(); ++i) {
        EXPECT_LT(laid.nodes[i].parent, static_cast<std::int32_t>(i));
        EXPECT_GT(laid.nodes[i].radius, 0);
      }
      for (const LaidFloret& f : laid.florets) {
        EXPECT_LT(f.node, static_cast<std::int32_t>(laid.nodes.size()));
        EXPECT_NEAR(glm::length(f.heading), 1, 1e-4);
        EXPECT_NEAR(glm::dot(f.heading, f.up), 0, 1e-4);
        EXPECT_GT(f.scale, 0);
        EXPECT_GE(f.stage, 0);
        EXPECT_LE(f.stage, 2);
      }
    }
}

/// Owens and others 2016: dense and yet no flower in another.
TEST(Inflorescence, FlowersDoNotCutThroughEachOther) {
  for (InflorescenceType type : kTypes)
    for (RoomOf room : {RoomOf(open_flower), RoomOf(bell)})
      for (double nod : {0.0, 70.0})
        for (int flowers : {12, 60}) {
          Inflorescence p = of(type, flowers);
          p.nod = radians(nod);
          p.sided = nod > 0 ? 0.7 : 0;
          EXPECT_LT(deepest_overlap(lay_inflorescence(p, 1, kDown, room, Seed{5}), room), 0.05)
              << static_cast<int>(type) << ' ' << flowers << ' ' << nod;
        }
}

TEST(Inflorescence, WithoutRoomFlowersWouldCut) {
  auto small = [](FloretRole, double) { return OrganRoom{0, 0, 1e-6}; };
  LaidInflorescence loose = lay_inflorescence(of(InflorescenceType::raceme, 60), 1, kDown, small, Seed{5});
  EXPECT_GT(deepest_overlap(loose, open_flower), 0.3);
}

TEST(Inflorescence, OpensFromTheOldestToTheYoungest) {
  for (bool basipetal : {false, true}) {
    Inflorescence p = of(InflorescenceType::raceme, 20);
    p.bract = "";
    p.basipetal = basipetal;
    LaidInflorescence laid = lay_inflorescence(p, 0, kDown, open_flower, Seed{1});
    const LaidFloret& low = laid.florets.front();
    const LaidFloret& high = laid.florets.back();
    EXPECT_LT(low.at.y, high.at.y);
    EXPECT_NEAR(low.stage, basipetal ? 0 : 1, 1e-6);
    EXPECT_NEAR(high.stage, basipetal ? 1 : 0, 1e-6);
    EXPECT_EQ(low.scale < high.scale, basipetal);
    // Later all are open, then all have withered.
    for (const LaidFloret& f : lay_inflorescence(p, 1, kDown, open_flower, Seed{1}).florets)
      EXPECT_GE(f.stage, 1);
    for (const LaidFloret& f : lay_inflorescence(p, -1, kDown, open_flower, Seed{1}).florets)
      EXPECT_NEAR(f.stage, 0, 1e-6);
  }
}

TEST(Inflorescence, TypesAreWhatTheyAreNamedFor) {
  auto laid = [](Inflorescence p) {
    p.jitter = 0, p.bract = "";
    return lay_inflorescence(
        p, 1, kDown,
        [](FloretRole, double) {
          return OrganRoom{0, 0, 1e-6};
        },
        Seed{2});
  };
  auto heights = [](const LaidInflorescence& l) {
    auto [low, high] = std::ranges::minmax(l.florets, {}, [](const LaidFloret& f) { return f.at.y; });
    return high.at.y - low.at.y;
  };
  EXPECT_GT(heights(laid(of(InflorescenceType::raceme))), 0.15f);
  EXPECT_LT(heights(laid(of(InflorescenceType::corymb))), 0.05f) << "in one plane";
  // All stalks of an umbel are from one place and of about one length.
  for (const LaidFloret& f : laid(of(InflorescenceType::umbel)).florets)
    EXPECT_NEAR(glm::distance(f.at, Vec3(0, 0.2f, 0)), 0.01f, 0.0011f);
  // Florets of a spadix stand off its axis by its radius.
  Inflorescence spadix = of(InflorescenceType::spadix, 200);
  for (const LaidFloret& f : laid(spadix).florets)
    EXPECT_LE(std::hypot(f.at.x, f.at.z), 0.5 * spadix.width + 1e-6);
  // A head has its rays at its rim.
  Inflorescence head = of(InflorescenceType::capitulum, 80);
  head.ray = "R";
  LaidInflorescence daisy = laid(head);
  EXPECT_EQ(count(daisy, FloretRole::ray), static_cast<std::size_t>(head.rays));
  for (const LaidFloret& f : daisy.florets) {
    if (f.role != FloretRole::ray) continue;
    EXPECT_NEAR(std::hypot(f.at.x, f.at.z), 0.5 * head.width, 0.1 * head.width);
  }
}

TEST(Inflorescence, NoddingFlowersHangDown) {
  Inflorescence p = of(InflorescenceType::raceme, 10);
  p.nod = radians(180.0), p.jitter = 0, p.bract = "";
  for (const LaidFloret& f : lay_inflorescence(p, 1, kDown, open_flower, Seed{1}).florets)
    EXPECT_LT(f.heading.y, -0.99f);
}

TEST(Inflorescence, IsTheSameForTheSameSeed) {
  for (InflorescenceType type : kTypes) {
    auto lay = [&](std::uint64_t seed) {
      return lay_inflorescence(of(type, 30), 0, kDown, bell, Seed{seed});
    };
    LaidInflorescence a = lay(7), b = lay(7);
    ASSERT_EQ(a.florets.size(), b.florets.size());
    for (std::size_t i = 0; i < a.florets.size(); ++i) EXPECT_EQ(a.florets[i].at, b.florets[i].at);
  }
  LaidInflorescence a = lay_inflorescence(of(InflorescenceType::raceme), 0, kDown, bell, Seed{7}),
                    b = lay_inflorescence(of(InflorescenceType::raceme), 0, kDown, bell, Seed{8});
  EXPECT_NE(a.florets.back().at, b.florets.back().at);
}

TEST(FloretCrowd, FindsWhereSegmentsAreNearest) {
  SegmentsGap crossed = gap_between(Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, -1), Vec3(0, 1, 1));
  EXPECT_NEAR(crossed.distance, 1, 1e-6);
  EXPECT_NEAR(gap_between(Vec3(0), Vec3(1, 0, 0), Vec3(3, 0, 0), Vec3(4, 0, 0)).distance, 2, 1e-6);
  EXPECT_NEAR(gap_between(Vec3(0), Vec3(0), Vec3(0, 2, 0), Vec3(0, 3, 0)).distance, 2, 1e-6);
  EXPECT_NEAR(gap_between(Vec3(0), Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(1, 0, 1)).distance, 1, 1e-6);
}

}  // namespace
}  // namespace frond
