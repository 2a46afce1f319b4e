#include "core/cell_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/seed.h"

namespace frond {
namespace {

std::vector<Vec3> some_places(std::size_t count, float wide) {
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < count; ++i) {
    Seed own = Seed(7).child(i);
    places.push_back(wide *
                     Vec3(own.child(0).range(-1, 1), own.child(1).range(-1, 1), own.child(2).range(-1, 1)));
  }
  return places;
}

std::vector<std::uint32_t> found_near(const CellGrid& grid, Vec3 at) {
  std::vector<std::uint32_t> found;
  grid.each(at, [&](std::uint32_t who) { found.push_back(who); });
  std::ranges::sort(found);
  return found;
}

TEST(CellGrid, FindsAllNeighboursOnce) {
  std::vector<Vec3> places = some_places(3000, 2);
  CellGrid grid(0.3f);
  for (std::uint32_t i = 0; i < places.size(); ++i) grid.add(places[i], i);
  for (Vec3 at : some_places(200, 2.2f)) {
    std::vector<std::uint32_t> found = found_near(grid, at);
    EXPECT_EQ(std::ranges::adjacent_find(found), found.end());
    for (std::uint32_t i = 0; i < places.size(); ++i)
      EXPECT_TRUE(glm::distance(places[i], at) > 0.3f || std::ranges::binary_search(found, i));
    // Nothing but what cells near by hold, whatever shares their chains.
    for (std::uint32_t i : found) EXPECT_LT(glm::distance(places[i], at), 2 * 0.3f * std::sqrt(3.0f));
  }
}

TEST(CellGrid, GivesTheLastFirst) {
  CellGrid grid(1);
  for (std::uint32_t i = 0; i < 3; ++i) grid.add(Vec3(0.5f), i);
  std::vector<std::uint32_t> order;
  grid.each(Vec3(0.4f), Vec3(0.6f), [&](std::uint32_t who) { order.push_back(who); });
  EXPECT_EQ(order, (std::vector<std::uint32_t>{2, 1, 0}));
}

TEST(CellGrid, FindsBoxesAndForgetsWhatWasAddedLast) {
  CellGrid grid(1);
  grid.add(Vec3(-3, 0, 0), Vec3(3, 0.5f, 0.5f), 4);
  std::size_t size = grid.size();
  EXPECT_EQ(size, 7u);
  grid.add(Vec3(2.5f, 0.2f, 0.2f), 5);
  EXPECT_EQ(found_near(grid, Vec3(2.5f, 0.5f, 0.5f)), (std::vector<std::uint32_t>{4, 4, 4, 5}));
  grid.shrink(size);
  EXPECT_EQ(found_near(grid, Vec3(2.5f, 0.5f, 0.5f)), (std::vector<std::uint32_t>{4, 4, 4}));
  EXPECT_TRUE(found_near(grid, Vec3(0, 9, 0)).empty());
}

TEST(CellGrid, FindsTheSameInTheSameOrderHoweverManyThereAre) {
  constexpr std::uint32_t kMany = 700'000;  // more than it has slots at first
  auto at = [](std::uint32_t i) { return Vec3(i % 977, i % 311, i % 89) * 0.7f; };
  CellGrid grid(1);
  for (std::uint32_t i = 0; i < kMany; ++i) grid.add(at(i), i);
  for (std::uint32_t asked : {0u, 1u, 54'321u, 699'999u}) {
    std::vector<std::uint32_t> here, wanted;
    Vec3 cell = glm::floor(at(asked)) + 0.5f;
    grid.each(cell, cell, [&](std::uint32_t who) { here.push_back(who); });
    for (std::uint32_t i = kMany; i-- > 0;)
      if (glm::floor(at(i)) == glm::floor(at(asked))) wanted.push_back(i);
    EXPECT_EQ(here, wanted);
  }
  grid.shrink(10);
  std::size_t left = 0;
  for (std::uint32_t i = 0; i < 12; ++i)
    grid.each(at(i), at(i), [&](std::uint32_t who) { left += who == i; });
  EXPECT_EQ(left, 10u);
}

TEST(Darts, KeepApartAndFillTheRoom) {
  Darts darts(0.4f);
  std::vector<Vec3> taken;
  for (Vec3 at : some_places(4000, 1)) {
    bool free = std::ranges::all_of(taken, [&](Vec3 other) { return glm::distance(other, at) >= 0.4f; });
    EXPECT_EQ(darts.try_add(at), free);
    if (free) taken.push_back(at);
  }
  EXPECT_GT(taken.size(), 50u);
}

TEST(CellGrid, WhatIsFarOffOrNoNumberHasACellToo) {
  CellGrid grid(0.01f);
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN(), kEndless = 1e38f;
  const Vec3 places[] = {{1, 2, 3}, {kEndless, 0, 0}, {0, -kEndless, 1e12f}, {kNone, 0, 0}};
  for (std::uint32_t i = 0; i < std::size(places); ++i) grid.add(places[i], i);
  for (std::uint32_t i = 0; i < std::size(places); ++i) {
    std::vector<std::uint32_t> found;
    grid.each(places[i], places[i], [&](std::uint32_t who) { found.push_back(who); });
    EXPECT_TRUE(std::ranges::find(found, i) != found.end()) << i;
  }
}

}  // namespace
}  // namespace frond
