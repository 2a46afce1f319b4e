#include "land/snow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frond {
namespace {

// A rectangle of two triangles that faces along a x b.
Surface plate(Vec3 from, Vec3 a, Vec3 b) {
  Surface s;
  s.position = {from, from + a, from + a + b, from + b};
  s.triangle = {{0, 1, 2}, {0, 2, 3}};
  set_normals(s);
  return s;
}

// Two metres wide, so many degrees steep.
Surface tilted(double degrees) {
  auto c = static_cast<float>(std::cos(radians(degrees))), s = static_cast<float>(std::sin(radians(degrees)));
  return plate({-1, 0, -1}, {0, 0, 2}, {2 * c, 2 * s, 0});
}

// A box with its foot at y = 0.
Surface block(Vec3 half) {
  Surface s;
  Vec3 x(2 * half.x, 0, 0), y(0, 2 * half.y, 0), z(0, 0, 2 * half.z), low(-half.x, 0, -half.z);
  for (const Surface& side : {plate(low + y, z, x), plate(low, x, z), plate(low, y, x), plate(low + z, x, y),
                              plate(low, z, y), plate(low + x, y, z)})
    append(s, side);
  return s;
}

TEST(CoverGrid, SheltersWhatFallsPastABody) {
  CoverGrid bodies({0, 0}, 10, 0.1f);
  bodies.add(plate({-1, 2, -1}, {0, 0, 2}, {2, 0, 0}));
  EXPECT_TRUE(bodies.shelters({0, 1, 0}, {0, -1, 0}));
  EXPECT_FALSE(bodies.shelters({0, 2.1f, 0}, {0, -1, 0})) << "above it";
  EXPECT_FALSE(bodies.shelters({1.5f, 1, 0}, {0, -1, 0})) << "beside it";
  EXPECT_FALSE(bodies.shelters({0.8f, 1, 0}, {-1, -1, 0})) << "the wind brings it in";
  EXPECT_TRUE(bodies.shelters({1.5f, 1, 0}, {1, -1, 0})) << "it has come by way of the plate";
}

float open_sky(Vec3) { return 1; }

float deepest(const SnowSheet& sheet) {
  return sheet.share.empty() ? 0 : *std::ranges::max_element(sheet.share);
}

// Of the prisms between what is bare and the snow.
double volume(const SnowSheet& sheet, double depth) {
  Surface snow = snow_surface(sheet, depth);
  double sum = 0;
  for (auto [a, b, c] : sheet.triangle) {
    auto p = [&](std::uint32_t i) { return glm::dvec3(sheet.bare[i]); };
    double area = std::abs((p(b).x - p(a).x) * (p(c).z - p(a).z) - (p(c).x - p(a).x) * (p(b).z - p(a).z)) / 2;
    for (std::uint32_t i : {a, b, c}) sum += area / 3 * std::max(0.0f, snow.position[i].y - sheet.bare[i].y);
  }
  return sum;
}

TEST(Snow, LiesLessTheSteeperItIs) {
  double last = 2;
  for (double slope = 0; slope <= 180; slope += 1) {
    double share = lying_share(std::cos(radians(slope)));
    EXPECT_LE(share, last);
    EXPECT_EQ(share == 0, slope >= 55) << slope;
    last = share;
  }
  EXPECT_EQ(lying_share(1), 1);
  double before = 2;
  for (double slope : {0.0, 20.0, 35.0, 40.0, 45.0, 50.0, 60.0}) {
    float deep = deepest(snow_on_body(tilted(slope), 0.1, 0.02f, open_sky));
    EXPECT_LE(deep, before + 1e-4) << slope;
    before = deep;
  }
  EXPECT_EQ(before, 0);
}

TEST(Snow, LiesOnTopOfABlockAlone) {
  Surface body = block({0.5f, 0.4f, 0.3f});
  SnowSheet cap = snow_on_body(body, 0.1, 0.02f, open_sky);
  ASSERT_FALSE(cap.triangle.empty());
  for (const Vec3& p : cap.bare) {
    EXPECT_NEAR(p.y, 0.8, 1e-5);
    EXPECT_LE(std::abs(p.x), 0.5 + 1e-5);
    EXPECT_LE(std::abs(p.z), 0.3 + 1e-5);
  }
  // Full depth in the middle, and round toward the edges.
  EXPECT_NEAR(deepest(cap), 1, 0.01);
  for (std::size_t i = 0; i < cap.bare.size(); ++i)
    if (std::max(std::abs(cap.bare[i].x) - 0.5f, std::abs(cap.bare[i].z) - 0.3f) > -0.015f) {
      EXPECT_LT(cap.share[i], 0.5);
    }
}

TEST(Snow, LiesOnUpperFacesNotUnderThem) {
  Surface table = block({0.6f, 0.02f, 0.4f});
  for (Vec3& p : table.position) p.y += 0.7f;
  Surface both = table;
  append(both, block({0.4f, 0.1f, 0.3f}));  // a box below it
  for (const Vec3& p : snow_on_body(both, 0.1, 0.02f, open_sky).bare) EXPECT_GT(p.y, 0.7);
}

TEST(Snow, NoneComesUnderARoofAndAllToTheOpen) {
  CoverGrid bodies(Vec2(0), 20, 0.08f);
  Surface roof = block({3, 0.05f, 3});
  for (Vec3& p : roof.position) p.y += 1.5f;
  bodies.add(roof);
  EXPECT_EQ(bodies.openness({0, 0, 0}), 0);
  EXPECT_EQ(bodies.openness({0, 1.6f, 0}), 1);
  EXPECT_EQ(bodies.openness({9, 0, 0}), 1);
  EXPECT_EQ(bodies.openness({100, 0, 0}), 1);
  float last = 0;
  for (float x = 0; x < 8; x += 0.25f) {
    float open = bodies.openness({x, 0, 0});
    EXPECT_GE(open, last - 1e-6) << x;
    last = open;
  }
}

SnowLand level_land() {
  SnowLand land{[](Vec2 at) { return 0.1 * std::sin(static_cast<double>(at.x)); }, Vec2(0), 10, 60, {}};
  land.trunks = {{Vec2(2, 0), 0.1f}};
  return land;
}

TEST(Snow, OnTheGroundIsScaledByWhatIsKept) {
  SnowLand land = level_land();
  CoverGrid none(Vec2(0), 20, 0.1f);
  SnowSheet all = snow_on_ground(land, none, {}, Seed{1});
  land.kept = [](Vec2 at) { return at.x < 0 ? 0.0 : 1.0; };
  SnowSheet half = snow_on_ground(land, none, {}, Seed{1});
  for (std::size_t i = 0; i < all.bare.size(); ++i)
    EXPECT_EQ(half.share[i], half.bare[i].x < 0 ? 0 : all.share[i]);
}

TEST(Snow, OnTheGroundIsNowhereBelowItAndHollowAtTrunks) {
  SnowLand land = level_land();
  CoverGrid none(Vec2(0), 20, 0.1f);
  SnowSheet snow = snow_on_ground(land, none, {}, Seed{1});
  double at_trunk = 1, all = 0;
  for (std::size_t i = 0; i < snow.bare.size(); ++i) {
    Vec2 at(snow.bare[i].x, snow.bare[i].z);
    EXPECT_NEAR(snow.bare[i].y, land.height(at), 1e-5);
    EXPECT_GT(snow.share[i], 0);
    all += snow.share[i] / static_cast<double>(snow.bare.size());
    if (glm::distance(at, Vec2(2, 0)) < 0.15) at_trunk = std::min<double>(at_trunk, snow.share[i]);
  }
  EXPECT_LT(at_trunk, 0.4);
  EXPECT_NEAR(all, 1, 0.1);
}

TEST(Snow, DriftsIntoTheLee) {
  SnowLand land = level_land();
  land.trunks.clear();
  CoverGrid wall(Vec2(0), 20, 0.1f);
  wall.add(block({0.15f, 0.5f, 3}));
  SnowSheet calm = snow_on_ground(land, wall, {}, Seed{1}),
            windy = snow_on_ground(land, wall, {Vec2(1, 0), 1}, Seed{1});
  auto mean = [&](const SnowSheet& snow, float from, float to) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < snow.bare.size(); ++i)
      if (const Vec3& p = snow.bare[i]; p.x > from && p.x < to && std::abs(p.z) < 1)
        sum += snow.share[i], ++count;
    return sum / count;
  };
  EXPECT_GT(mean(windy, 0.6f, 2), 1.2 * mean(calm, 0.6f, 2));
  EXPECT_LT(mean(windy, -1.2f, -0.4f), 0.9 * mean(calm, -1.2f, -0.4f));
}

TEST(Snow, GrowsInProportionToItsDepth) {
  std::vector<SnowSheet> sheets{snow_on_body(block({0.5f, 0.4f, 0.3f}), 0.2, 0.02f, open_sky),
                                snow_on_ground(level_land(), CoverGrid(Vec2(0), 20, 0.1f), {}, Seed{1})};
  for (const SnowSheet& sheet : sheets) {
    double last = -1;
    Surface before = snow_surface(sheet, 0);
    for (const Vec3* p = before.position.data(); p < before.position.data() + before.position.size(); ++p)
      EXPECT_LT(p->y, sheet.bare[static_cast<std::size_t>(p - before.position.data())].y);  // hidden
    for (double depth = 0; depth <= 0.2; depth += 0.01) {
      double now = volume(sheet, depth);
      EXPECT_GE(now, last);
      last = now;
      Surface next = snow_surface(sheet, depth + 0.01);
      Surface here = snow_surface(sheet, depth);
      for (std::size_t i = 0; i < here.position.size(); ++i) {
        float rise = next.position[i].y - here.position[i].y;
        EXPECT_TRUE(rise >= 0 && rise <= 0.01f * 4) << rise;
      }
    }
  }
}

}  // namespace
}  // namespace frond
