#include "accretion/margin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "accretion/sheet_body.h"
#include "closed.h"
#include "crossings.h"

namespace frond {
namespace {

MarginStart arc_of(Vec3 middle, double radius, double turn, double arc, double pitch) {
  MarginStart start;
  start.from_middle = static_cast<float>(radius);
  start.closed = arc > 2 * kPi - 1e-6;
  int parts = static_cast<int>(std::ceil(arc * radius / 0.005)) + 5;
  for (int i = 0; i < parts; ++i) {
    double angle = turn - arc * i / parts;
    Vec3 out(static_cast<float>(std::cos(angle)), 0, static_cast<float>(std::sin(angle)));
    start.rim.push_back(middle + out * static_cast<float>(radius));
    start.heading.push_back(out * static_cast<float>(std::cos(pitch)) +
                            Vec3(0, static_cast<float>(std::sin(pitch)), 0));
  }
  return start;
}

std::vector<MarginStart> whorl_of(std::uint64_t seed) {
  std::vector<MarginStart> starts;
  for (int i = 0; i < 5; ++i) {
    double share = i / 4.0;
    starts.push_back(arc_of(Vec3(0), 0.08 - 0.06 * share, radians(137.5) * i + static_cast<double>(seed),
                            radians(130.0), radians(40.0 + 40 * share)));
  }
  return starts;
}

const Margin kRuffled{.reach = 0.2, .edge = 0.005, .excess = 2.5, .pitch = 1, .light = 1, .clearance = 0.012};

SheetSkin skin_of() {
  SheetSkin skin;
  skin.upper = skin.lower = [](std::uint32_t, float age) { return 0.001f + 0.002f * age; };
  return skin;
}

TEST(Margin, SheetsNeverCrossThemselves) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Sheet sheet = grow_margins(kRuffled, whorl_of(seed), {}, Seed{seed});
    Surface surface;
    surface.position = sheet.position;
    surface.triangle = sheet.triangle;
    EXPECT_GT(sheet.triangle.size(), 10000u);
    EXPECT_EQ(crossings_of(surface, 0.008f), 0u) << "seed " << seed;
  }
}

TEST(Margin, AFlatDiscStaysFlatAndDoesNotCross) {
  Margin law{.reach = 0.2, .edge = 0.006, .stiffness = 1, .pitch = 0, .light = 4, .lobes = 0.5};
  MarginStart start = arc_of(Vec3(0), 0.012, 0, 2 * kPi, 0);
  start.filled = true;
  Sheet sheet = grow_margins(law, {start}, {}, Seed{4});
  Surface surface;
  surface.position = sheet.position;
  surface.triangle = sheet.triangle;
  EXPECT_EQ(crossings_of(surface, 0.009f), 0u);
  for (Vec3 p : sheet.position) EXPECT_NEAR(p.y, 0, 1e-3);
  auto turned = std::ranges::count_if(sheet.normal, [](Vec3 n) { return n.y < 0.9f; });
  EXPECT_LE(turned, std::ssize(sheet.normal) / 1000);
}

TEST(Margin, BodiesAreClosed) {
  Sheet sheet = grow_margins(kRuffled, whorl_of(2), {}, Seed{2});
  SheetBody body = body_of(sheet, skin_of());
  EXPECT_EQ(body.surface.find_fault(), "");
  Body solid = body_of(body.surface);
  EXPECT_EQ(solid.loose, 0u);
  EXPECT_GT(solid.volume, 0);
}

TEST(Margin, StaysWithinItsRoom) {
  MarginWorld world;
  world.room = [](Vec3 at, float) { return 0.05f - at.x; };
  Sheet sheet = grow_margins(kRuffled, {arc_of(Vec3(0), 0.02, 0, 2 * kPi, 0.5)}, world, Seed{3});
  float far = -1;
  for (Vec3 p : sheet.position) far = std::max(far, p.x);
  EXPECT_LT(far, 0.05f);
  EXPECT_GT(far, 0.03f);
}

TEST(Margin, SkeletonNeverMovesAndNothingPops) {
  Sheet sheet = grow_margins(kRuffled, whorl_of(5), {}, Seed{5});
  auto step = static_cast<float>(kRuffled.edge);
  std::vector<Vec3> last = sheet_at(sheet, 0);
  for (int row = 1; row <= sheet.rows; ++row) {
    std::vector<Vec3> now = sheet_at(sheet, static_cast<float>(row));
    for (std::size_t v = 0; v < now.size(); ++v) {
      ASSERT_LT(glm::distance(now[v], last[v]), 2.5f * step) << "row " << row;
      if (sheet.row[v] <= static_cast<float>(row)) {
        ASSERT_EQ(now[v], sheet.position[v]);
      }
    }
    last = std::move(now);
  }
}

TEST(Margin, ARimThatOutgrowsASheetRuffles) {
  auto rise = [](double excess) {
    Margin law{.reach = 0.2,
               .edge = 0.005,
               .excess = excess,
               .stiffness = 0.2,
               .pitch = 0,
               .light = 0.2,
               .lobes = 0};
    MarginStart start = arc_of(Vec3(0), 0.01, 0, 2 * kPi, 0);
    start.filled = true;
    float low = 0, high = 0;
    for (Vec3 p : grow_margins(law, {start}, {}, Seed{7}).position)
      low = std::min(low, p.y), high = std::max(high, p.y);
    return high - low;
  };
  EXPECT_LT(rise(1), 0.002f);
  EXPECT_GT(rise(2.5), 0.03f);
}

/// A crust on a host with points, each of which is the nearest place of the host for all that comes near.
TEST(Margin, WhatIsDrawnBackToAPointOfItsHostStaysAtFinitePlaces) {
  MarginWorld world;
  world.cling = [](Vec3& at, Vec3& normal) {
    Vec3 point(std::round(at.x * 25) / 25, 0, std::round(at.z * 25) / 25);
    at.y = 0, normal = {0, 1, 0};
    if (glm::distance(at, point) < 0.009f) at = point;
  };
  Margin law{.reach = 0.15, .edge = 0.006, .lobes = 0.3, .clearance = 0.012};
  MarginStart start = arc_of(Vec3(0), 0.012, 0, 2 * kPi, 0);
  start.filled = true;
  Sheet sheet = grow_margins(law, {start}, world, Seed{4});
  EXPECT_GT(sheet.position.size(), 300u);
  EXPECT_EQ(body_of(sheet, skin_of()).surface.find_fault(), "");
}

TEST(Margin, IsTheSameEachTime) {
  Sheet a = grow_margins(kRuffled, whorl_of(1), {}, Seed{1}),
        b = grow_margins(kRuffled, whorl_of(1), {}, Seed{1});
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.triangle, b.triangle);
  EXPECT_NE(a.position, grow_margins(kRuffled, whorl_of(1), {}, Seed{2}).position);
}

}  // namespace
}  // namespace frond
