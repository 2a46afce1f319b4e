#include "core/cancellation.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <mutex>

#include "core/parallel.h"

namespace frond {
namespace {

TEST(Wanted, WorkThatIsGivenUpEndsOnAllThreadsAndInLoopsWithinLoops) {
  std::atomic<bool> gone = false;
  std::atomic<int> rounds = 0;
  auto work = [&] {
    parallel_for(1000, [&](std::size_t) {
      parallel_for(1000, [&](std::size_t) {
        if (++rounds == 500) gone = true;
      });
    });
  };
  EXPECT_THROW(while_wanted([&] { return gone.load(); }, work), Cancelled);
  EXPECT_LT(rounds, 500 + 2 * thread_count()) << "each thread may be in a round";
}

TEST(Wanted, WhatNobodyAsksAboutRunsToItsEnd) {
  std::atomic<int> rounds = 0;
  while_wanted({}, [&] { parallel_for(100, [&](std::size_t) { stay_wanted(), ++rounds; }); });
  EXPECT_EQ(rounds, 100);
  while_wanted([] { return false; }, [&] { parallel_for(100, [&](std::size_t) { ++rounds; }); });
  EXPECT_EQ(rounds, 200);
}

TEST(Wanted, AfterWorkThatWasGivenUpThreadsAreFreeForOther) {
  for (int i = 0; i < 20; ++i) {
    EXPECT_THROW(while_wanted([] { return true; }, [] { parallel_for(64, [](std::size_t) {}); }), Cancelled);
    std::atomic<int> rounds = 0;
    parallel_for(64, [&](std::size_t) { stay_wanted(), ++rounds; });
    EXPECT_EQ(rounds, 64);
  }
}

TEST(Isolated, AThreadThatWaitsForItsOwnTasksUnderALockTakesUpNoOther) {
  std::mutex lock;
  std::atomic<int> done = 0;
  parallel_for(200, [&](std::size_t) {
    std::lock_guard held(lock);  // taken twice by one thread it would hang
    isolated([] { tbb::parallel_for(0, 64, [](int) {}); });
    ++done;
  });
  EXPECT_EQ(done, 200);
}

}  // namespace
}  // namespace frond
