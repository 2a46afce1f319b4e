#include "core/shelf.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace frond {
namespace {

std::shared_ptr<const int> boxed(int value) { return std::make_shared<const int>(value); }

TEST(Shelf, GivesUpWhatWasNotAskedForLongest) {
  auto room = std::make_shared<Storeroom>(10'000);
  Shelf<int> shelf(room);
  shelf.put("a", boxed(1), 4000);
  shelf.put("b", boxed(2), 4000);
  ASSERT_TRUE(shelf.find("a"));
  shelf.put("c", boxed(3), 4000);
  EXPECT_TRUE(shelf.find("a"));
  EXPECT_FALSE(shelf.find("b"));
  EXPECT_TRUE(shelf.find("c"));
  EXPECT_LE(room->taken(), room->room());
}

TEST(Shelf, AllShelvesOfARoomTogetherKeepToIt) {
  auto room = std::make_shared<Storeroom>(100'000);
  Shelf<int> numbers(room);
  Shelf<std::string> texts(room);
  for (int i = 0; i < 100; ++i) {
    numbers.put(std::to_string(i), boxed(i), 3000);
    texts.put(std::to_string(i), std::make_shared<const std::string>("x"), 5000);
    EXPECT_LE(room->taken(), room->room());
  }
  EXPECT_FALSE(numbers.find("0"));
  EXPECT_FALSE(texts.find("0"));
  ASSERT_TRUE(numbers.find("99"));
  EXPECT_EQ(*numbers.find("99"), 99) << "the same name on another shelf is another thing";
  EXPECT_EQ(*texts.find("99"), "x");
}

TEST(Shelf, WhatWasPutThereLastStaysHoweverLarge) {
  auto room = std::make_shared<Storeroom>(1000);
  Shelf<int> shelf(room);
  shelf.put("small", boxed(1), 100);
  shelf.put("large", boxed(2), 1'000'000);
  EXPECT_FALSE(shelf.find("small"));
  EXPECT_TRUE(shelf.find("large"));
  shelf.put("small", boxed(1), 100);
  EXPECT_FALSE(shelf.find("large"));
  EXPECT_TRUE(shelf.find("small"));
}

TEST(Shelf, WhatIsInUseOutlivesItsPlace) {
  Shelf<int> shelf(1000);
  shelf.put("a", boxed(7), 900);
  auto held = shelf.find("a");
  shelf.put("b", boxed(8), 900);
  EXPECT_FALSE(shelf.find("a"));
  EXPECT_EQ(*held, 7);
}

TEST(Shelf, MayBeAskedFromManyThreads) {
  auto room = std::make_shared<Storeroom>(50'000);
  Shelf<int> shelf(room);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&shelf, t] {
      for (int i = 0; i < 2000; ++i) {
        std::string name = std::to_string((i * 7 + t) % 50);
        auto found = shelf.find(name);
        EXPECT_EQ(found ? *found : std::stoi(name), std::stoi(name));
        if (!found) shelf.put(name, boxed(std::stoi(name)), 2000);
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_LE(room->taken(), room->room());
}

}  // namespace
}  // namespace frond
