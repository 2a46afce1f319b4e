#include "land/sow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace frond {
namespace {

using Sown = std::vector<std::vector<Sprout>>;

SowOrder order_of(int count, double radius, Layer layer = Layer::canopy) {
  static std::uint64_t number = 0;
  SowOrder order;
  order.count = count;
  order.rules.layer = layer;
  order.rules.radius = radius;
  order.rules.stem = 0.2 * radius;
  order.seed = Seed{++number};
  return order;
}

/// Hills 10 m high with valleys at x = 0, 40, ..., and a path along z = 5.
Land hilly() {
  Land land;
  land.size = 120;
  land.altitude = [](Vec2 at) { return 5 - 5 * std::cos(2 * kPi * at.x / 40); };
  land.slope = [](Vec2 at) { return std::atan(5 * 2 * kPi / 40 * std::abs(std::sin(2 * kPi * at.x / 40))); };
  land.path = [](Vec2 at) { return std::abs(at.y - 5) - 1.0; };
  return land;
}

/// Share of a square covered by disks of the crowns' size.
double packing(const SowOrder& order, const std::vector<Sprout>& sprouts, double size) {
  double area = 0;
  for (const Sprout& s : sprouts) area += kPi * std::pow(order.rules.radius * s.size, 2);
  return area / (size * size);
}

/// A slope that rises 500 m over a kilometre toward +x.
Land mountain_side() {
  Land land;
  land.size = 1000;
  land.altitude = [](Vec2 at) { return 0.5 * (at.x + 500); };
  return land;
}

TEST(Sow, InTheColdPlantsAreSmallerAndFewer) {
  SowOrder order = order_of(3000, 3);
  order.rules.warmth = Warmth{.lowest = 9, .full = 8.4, .least = 6.6, .dwarf = 0.2};  // 100 m to 400 m
  std::vector<Sprout> sprouts = sow(std::span(&order, 1), mountain_side())[0];
  std::array<int, 5> count{};
  for (const Sprout& s : sprouts) {
    double altitude = 0.5 * (s.at.x + 500);
    EXPECT_LT(altitude, 400);
    EXPECT_NEAR(s.size, altitude < 100 ? 1 : 1 - 0.8 * (altitude - 100) / 300, 1e-4);
    ++count[static_cast<std::size_t>(altitude / 100)];
  }
  EXPECT_GT(count[0], count[1]);
  EXPECT_GT(count[1], count[2]);
  EXPECT_GT(count[2], count[3]);
  EXPECT_GT(count[3], 0);
}

TEST(Sow, CropsStandInTheirRowsAndMissTheirGaps) {
  Land land;
  land.size = 40;
  SowOrder order = order_of(4000, 0.08, Layer::herbs);
  order.rules.rows = CropRows{.spacing = 0.8, .turn = 0.5, .wander = 0.05, .gaps = 0, .gap = 1};
  Vec2 along(std::sin(0.5f), std::cos(0.5f)), across(along.y, -along.x);
  auto stretches = [&](double gaps) {
    order.rules.rows->gaps = gaps;
    std::vector<Sprout> sprouts = sow(std::span(&order, 1), land)[0];
    EXPECT_EQ(sprouts.size(), 4000u);
    std::set<std::pair<double, double>> found;
    for (const Sprout& s : sprouts) {
      double aside = glm::dot(s.at, across) / 0.8, row = std::round(aside);
      EXPECT_LE(std::abs(aside - row) * 0.8, 0.05 + 1e-4);
      found.emplace(row, std::floor(glm::dot(s.at, along)));
    }
    return static_cast<double>(found.size());
  };
  double all = stretches(0);
  EXPECT_NEAR(stretches(0.3) / all, 0.7, 0.06);
}

TEST(Sow, SmallPlantsOfTheColdStandCloser) {
  // Their crowns keep apart by their own size.
  SowOrder order = order_of(4000, 4);
  order.rules.warmth = Warmth{.lowest = 7, .full = 9, .least = 3, .dwarf = 0.2};
  std::vector<Sprout> sprouts = sow(std::span(&order, 1), mountain_side())[0];
  for (std::size_t i = 0; i < sprouts.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      ASSERT_GE(glm::distance(sprouts[i].at, sprouts[k].at),
                0.999f * 4 * (sprouts[i].size + sprouts[k].size));
}

TEST(Sow, NoTwoCrownsOfALayerOverlapAndNoStemsOfTwo) {
  Land land = hilly();
  land.taken = {{{10, 20}, 6}, {{-30, -20}, 0.5f}};
  std::vector<SowOrder> orders{order_of(150, 3), order_of(120, 1.4), order_of(300, 0.8, Layer::shrubs),
                               order_of(900, 0.3, Layer::herbs), order_of(700, 0.2, Layer::herbs)};
  for (SowOrder& order : orders) order.size_variation = 0.4;
  Sown sown = sow(orders, land);
  struct Plant {
    Vec2 at;
    double radius, stem;
    Layer layer;
  };
  std::vector<Plant> all;
  for (std::size_t o = 0; o < orders.size(); ++o) {
    EXPECT_GT(sown[o].size(), 80u) << o;
    for (const Sprout& s : sown[o]) {
      EXPECT_LE(std::max(std::abs(s.at.x), std::abs(s.at.y)), 60.001f);
      EXPECT_GE(s.size, 0.6f);
      EXPECT_LE(s.size, 1.4f);
      all.push_back(
          {s.at, orders[o].rules.radius * s.size, orders[o].rules.stem * s.size, orders[o].rules.layer});
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const Spot& spot : land.taken)
      EXPECT_GT(glm::distance(spot.at, all[i].at), spot.radius + all[i].stem - 1e-3);
    for (std::size_t k = 0; k < i; ++k) {
      double least = all[i].layer == all[k].layer ? all[i].radius + all[k].radius : all[i].stem + all[k].stem;
      EXPECT_GT(glm::distance(all[i].at, all[k].at), least - 1e-3);
    }
  }
}

TEST(Sow, FillsItsLand) {
  // Darts that are thrown for ever cover 0.547 (Renyi's parking in the plane); a lattice of points apart as
  // far as may be 0.6 to 0.7, hexagons 0.907.
  Land land;
  std::vector<SowOrder> orders{order_of(20000, 1)};
  Sown sown = sow(orders, land);
  double share = packing(orders[0], sown[0], land.size);
  EXPECT_GT(share, 0.45);
  EXPECT_LT(share, 0.58);
  // As dense at the edges as in the middle.
  double inside = 0;
  for (const Sprout& s : sown[0]) inside += std::max(std::abs(s.at.x), std::abs(s.at.y)) < 25;
  EXPECT_NEAR(inside / static_cast<double>(sown[0].size()), 0.25, 0.02);
}

TEST(Sow, GivesAsManyAsAskedWhereThereIsRoom) {
  std::vector<SowOrder> orders{order_of(1000, 1), order_of(0, 1)};
  Land land;
  Sown sown = sow(orders, land);
  EXPECT_EQ(sown[0].size(), 1000u);
  EXPECT_EQ(sown[1].size(), 0u);
  // Spread over all of it.
  int quarter[4] = {};
  for (const Sprout& s : sown[0]) ++quarter[(s.at.x > 0) + 2 * (s.at.y > 0)];
  for (int n : quarter) EXPECT_NEAR(n, 250, 35);
}

TEST(Sow, KeepsToAltitudeSlopeAndPath) {
  Land land = hilly();
  std::vector<SowOrder> orders{order_of(400, 0.6, Layer::shrubs), order_of(400, 0.6, Layer::shrubs),
                               order_of(400, 0.6, Layer::shrubs)};
  orders[0].rules.altitude = {-100, 4};
  orders[1].rules.altitude = {6, 1e4};
  orders[1].rules.clear = 3;
  orders[2].rules.slope = radians(25.0);
  orders[2].rules.clear = -1e2;
  Sown sown = sow(orders, land);
  double valley = 0, top = 0, on_path = 0;
  for (const Sprout& s : sown[0]) {
    EXPECT_LE(land.altitude(s.at), 4);
    EXPECT_GE(land.path(s.at), 0.5);
    valley += land.altitude(s.at) < 1.5;
  }
  for (const Sprout& s : sown[1]) {
    EXPECT_GE(land.altitude(s.at), 6);
    EXPECT_GE(land.path(s.at), 3);
    top += land.altitude(s.at) > 8.5;
  }
  for (const Sprout& s : sown[2]) {
    EXPECT_LE(land.slope(s.at), radians(25.0));
    on_path += land.path(s.at) < 0;
  }
  for (const auto& stand : sown) EXPECT_EQ(stand.size(), 400u);
  // At an end that the land does not reach nothing is rarer.
  EXPECT_GT(valley, 180);
  EXPECT_GT(top, 180);
  EXPECT_GT(on_path, 2);
}

TEST(Sow, StaysWithinItsReach) {
  Land land;
  std::vector<SowOrder> orders{order_of(60, 0.5), order_of(60, 0.5)};
  orders[0].rules.center = {30, -20};
  orders[0].rules.reach = 9;
  orders[1].rules.center = {1000, 0};
  orders[1].rules.reach = 5;
  Sown sown = sow(orders, land);
  EXPECT_EQ(sown[0].size(), 60u);
  for (const Sprout& s : sown[0]) EXPECT_LE(glm::distance(s.at, Vec2(30, -20)), 9);
  EXPECT_EQ(sown[1].size(), 0u);
}

/// How much the numbers of plants in squares of `side` metres scatter: 1 for places at random.
double clumping(const std::vector<Sprout>& sprouts, double size, double side) {
  auto rows = static_cast<std::size_t>(size / side);
  std::vector<double> number(rows * rows);
  for (const Sprout& s : sprouts) {
    auto row = [&](float at) { return std::min(static_cast<std::size_t>((at + size / 2) / side), rows - 1); };
    ++number[row(s.at.y) * rows + row(s.at.x)];
  }
  double mean = static_cast<double>(sprouts.size()) / static_cast<double>(number.size()), square = 0;
  for (double n : number) square += (n - mean) * (n - mean);
  return square / static_cast<double>(number.size()) / mean;
}

TEST(Sow, ClumpsCoverTheirShare) {
  Land land;
  land.size = 200;
  std::vector<SowOrder> orders{order_of(2000, 0.3)};
  double even = clumping(sow(orders, land)[0], 200, 10);
  EXPECT_LT(even, 1.1);
  for (double cover : {0.1, 0.3, 0.6}) {
    orders[0].rules.patch = 25;
    orders[0].rules.cover = cover;
    std::vector<Sprout> clumped = sow(orders, land)[0];
    EXPECT_EQ(clumped.size(), 2000u);
    EXPECT_GT(clumping(clumped, 200, 10), 2 * even) << cover;
    // Squares of 4 m with a plant: most of the clumps, none of the rest.
    std::vector<bool> there(2500);
    for (const Sprout& s : clumped) {
      auto row = [](float at) { return std::min(static_cast<std::size_t>((at + 100) / 4), std::size_t{49}); };
      there[row(s.at.y) * 50 + row(s.at.x)] = true;
    }
    double share = static_cast<double>(std::count(there.begin(), there.end(), true)) / 2500;
    EXPECT_GT(share, 0.6 * cover);
    EXPECT_LT(share, 1.35 * cover + 0.1);
  }
  orders[0].rules.cover = 0;
  EXPECT_EQ(sow(orders, land)[0].size(), 0u);
}

TEST(Sow, FernsLikeTheShadeAndFlowersTheLight) {
  Land land;
  std::vector<SowOrder> orders{order_of(150, 3), order_of(500, 0.2, Layer::herbs),
                               order_of(500, 0.2, Layer::herbs), order_of(200, 1, Layer::shrubs)};
  orders[0].rules.reach = 40;
  orders[1].rules.shade = {0.7, 1};
  orders[2].rules.shade = {0, 0.3};
  orders[3].rules.shade = {0, 0.5};
  Sown sown = sow(orders, land);
  auto shade = [&](Vec2 at, std::initializer_list<std::size_t> of) {
    double open = 1;
    for (std::size_t o : of)
      for (const Sprout& s : sown[o])
        open *= 1 - hidden_sky(glm::distance(at, s.at), orders[o].rules.radius * s.size);
    return 1 - open;
  };
  for (const auto& stand : sown) EXPECT_GT(stand.size(), 80u);
  for (const Sprout& s : sown[1]) EXPECT_GE(shade(s.at, {0, 3}), 0.7 - 1e-4);
  for (const Sprout& s : sown[2]) EXPECT_LE(shade(s.at, {0, 3}), 0.3 + 1e-4);
  for (const Sprout& s : sown[3]) EXPECT_LE(shade(s.at, {0}), 0.5 + 1e-4);
}

TEST(Sow, FollowsItsMap) {
  // Left dark, right bright, the bottom quarter half as bright.
  std::vector<float> grey(64 * 64, 0);
  for (std::size_t y = 0; y < 64; ++y)
    for (std::size_t x = 32; x < 64; ++x) grey[64 * y + x] = y < 48 ? 1 : 0.5f;
  Land land;
  std::vector<SowOrder> orders{order_of(1000, 0.2)};
  Mask& map = orders[0].rules.map;
  map.width = map.height = 64;
  map.grey = std::make_shared<const std::vector<float>>(std::move(grey));
  std::vector<Sprout> sown = sow(orders, land)[0];
  EXPECT_EQ(sown.size(), 1000u);
  int bright = 0, half = 0;
  for (const Sprout& s : sown) {
    EXPECT_GT(s.at.x, -1.6f);
    ++(s.at.y < 25 ? bright : half);  // the picture's top is -z
  }
  EXPECT_NEAR(half / static_cast<double>(bright), 0.5 / 3, 0.04);
}

TEST(Sow, NeighboursOfAKindAreOfDifferentModels) {
  Land land;
  for (int models : {2, 3, 8}) {
    std::vector<SowOrder> orders{order_of(1500, 0.7)};
    orders[0].models = models;
    // A lattice, where all are equally near.
    for (int i = 0; i < 81; ++i)
      orders[0].at.emplace_back(static_cast<float>(i % 9) * 2 - 8, static_cast<float>(i / 9) * 2 - 8);
    std::vector<Sprout> sown = sow(orders, land)[0];
    std::vector<int> used(static_cast<std::size_t>(models));
    for (std::size_t i = 0; i < sown.size(); ++i) {
      ASSERT_LT(sown[i].model, models);
      ++used[sown[i].model];
      std::size_t nearest = i ? 0 : 1;
      for (std::size_t k = 0; k < sown.size(); ++k)
        if (k != i && glm::distance(sown[k].at, sown[i].at) < glm::distance(sown[nearest].at, sown[i].at))
          nearest = k;
      EXPECT_NE(sown[i].model, sown[nearest].model) << i;
    }
    for (int n : used) EXPECT_NEAR(n, 1500.0 / models, 300.0 / models);
  }
  std::vector<SowOrder> alone{order_of(1, 1)};
  alone[0].models = 3;
  EXPECT_EQ(sow(alone, land)[0].size(), 1u);
}

TEST(Sow, LaterKindsOfOneSizeAreNotStarved) {
  Land land;
  std::vector<SowOrder> orders{order_of(4000, 1), order_of(4000, 1), order_of(4000, 1.05)};
  Sown sown = sow(orders, land);
  EXPECT_NEAR(static_cast<double>(sown[1].size()), static_cast<double>(sown[0].size()), 90);
  EXPECT_NEAR(static_cast<double>(sown[2].size()), static_cast<double>(sown[0].size()), 150);
  // But trees come before saplings, wherever they stand in the list.
  std::vector<SowOrder> mixed{order_of(4000, 0.4), order_of(300, 2.5)};
  EXPECT_GT(sow(mixed, land)[1].size(), 205u);
}

TEST(Sow, StartsAtGivenPlaces) {
  Land land = hilly();
  std::vector<SowOrder> orders{order_of(40, 2)};
  orders[0].at = {{0, 5}, {1, 5}};  // on the path and too near to each other: as the user wants it
  std::vector<Sprout> sown = sow(orders, land)[0];
  ASSERT_EQ(sown.size(), 40u);
  EXPECT_EQ(sown[0].at, Vec2(0, 5));
  EXPECT_EQ(sown[1].at, Vec2(1, 5));
  for (std::size_t i = 2; i < sown.size(); ++i) EXPECT_GT(glm::distance(sown[i].at, sown[0].at), 3.999f);
}

TEST(Sow, IsTheSameForTheSameSeed) {
  Land land = hilly();
  std::vector<SowOrder> orders{order_of(100, 2), order_of(300, 0.3, Layer::herbs)};
  Sown one = sow(orders, land), two = sow(orders, land);
  for (std::size_t o = 0; o < orders.size(); ++o) {
    ASSERT_EQ(one[o].size(), two[o].size());
    for (std::size_t i = 0; i < one[o].size(); ++i) {
      EXPECT_EQ(one[o][i].at, two[o][i].at);
      EXPECT_EQ(one[o][i].model, two[o][i].model);
    }
  }
  // Another herb moves no tree.
  orders[1].count = 10;
  Sown fewer = sow(orders, land);
  for (std::size_t i = 0; i < one[0].size(); ++i) EXPECT_EQ(one[0][i].at, fewer[0][i].at);
}

TEST(Sow, TakesExtremes) {
  Land land;
  land.size = 4000;
  std::vector<SowOrder> orders{order_of(200, 0.01, Layer::herbs), order_of(5, 100)};
  orders[0].rules.stem = 0;
  Sown sown = sow(orders, land);
  EXPECT_EQ(sown[0].size(), 200u);
  EXPECT_EQ(sown[1].size(), 5u);
  land.size = 2;
  EXPECT_EQ(sow(orders, land)[1].size(), 1u);  // it stands out on all sides
}

TEST(Sow, AMillionWithoutRoomAreGivenUpAtOnce) {
  Land land;
  int asked = 0;
  constexpr int kCorners = 161 * 161;  // that the land is looked at before sowing
  land.slope = [&](Vec2) { return asked++ < kCorners ? 0.0 : 9.0; };
  SowOrder order = order_of(1'000'000, 0.01);
  EXPECT_TRUE(sow(std::vector{order}, land)[0].empty());
  EXPECT_LT(asked, 10 * kCorners);  // of 40 million darts
}

}  // namespace
}  // namespace frond
