#include "core/lru_cache.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace frond {
namespace {

std::shared_ptr<const int> boxed(int value) { return std::make_shared<const int>(value); }

TEST(LruCache, GivesUpWhatWasNotAskedForLongest) {
  auto budget = std::make_shared<CacheBudget>(10'000);
  LruCache<int> cache(budget);
  cache.put("a", boxed(1), 4000);
  cache.put("b", boxed(2), 4000);
  ASSERT_TRUE(cache.find("a"));
  cache.put("c", boxed(3), 4000);
  EXPECT_TRUE(cache.find("a"));
  EXPECT_FALSE(cache.find("b"));
  EXPECT_TRUE(cache.find("c"));
  EXPECT_LE(budget->used(), budget->capacity());
}

TEST(LruCache, AllShelvesOfARoomTogetherKeepToIt) {
  auto budget = std::make_shared<CacheBudget>(100'000);
  LruCache<int> numbers(budget);
  LruCache<std::string> texts(budget);
  for (int i = 0; i < 100; ++i) {
    numbers.put(std::to_string(i), boxed(i), 3000);
    texts.put(std::to_string(i), std::make_shared<const std::string>("x"), 5000);
    EXPECT_LE(budget->used(), budget->capacity());
  }
  EXPECT_FALSE(numbers.find("0"));
  EXPECT_FALSE(texts.find("0"));
  ASSERT_TRUE(numbers.find("99"));
  EXPECT_EQ(*numbers.find("99"), 99) << "the same name on another cache is another thing";
  EXPECT_EQ(*texts.find("99"), "x");
}

TEST(LruCache, WhatWasPutThereLastStaysHoweverLarge) {
  auto budget = std::make_shared<CacheBudget>(1000);
  LruCache<int> cache(budget);
  cache.put("small", boxed(1), 100);
  cache.put("large", boxed(2), 1'000'000);
  EXPECT_FALSE(cache.find("small"));
  EXPECT_TRUE(cache.find("large"));
  cache.put("small", boxed(1), 100);
  EXPECT_FALSE(cache.find("large"));
  EXPECT_TRUE(cache.find("small"));
}

TEST(LruCache, WhatIsInUseOutlivesItsPlace) {
  LruCache<int> cache(1000);
  cache.put("a", boxed(7), 900);
  auto held = cache.find("a");
  cache.put("b", boxed(8), 900);
  EXPECT_FALSE(cache.find("a"));
  EXPECT_EQ(*held, 7);
}

TEST(LruCache, MayBeAskedFromManyThreads) {
  auto budget = std::make_shared<CacheBudget>(50'000);
  LruCache<int> cache(budget);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&cache, t] {
      for (int i = 0; i < 2000; ++i) {
        std::string name = std::to_string((i * 7 + t) % 50);
        auto found = cache.find(name);
        EXPECT_EQ(found ? *found : std::stoi(name), std::stoi(name));
        if (!found) cache.put(name, boxed(std::stoi(name)), 2000);
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_LE(budget->used(), budget->capacity());
}

}  // namespace
}  // namespace frond
