#include "core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <stdexcept>

namespace frond {
namespace {

TEST(ParallelFor, LetsAnExceptionOutInsteadOfEndingTheProcess) {
  auto fails = [](std::size_t i) {
    if (i == 37) throw std::bad_alloc();
  };
  EXPECT_THROW(parallel_for(100, fails), std::bad_alloc);
  auto nested = [](std::size_t) {
    parallel_for(10, [](std::size_t k) {
      if (k == 3) throw std::runtime_error("inner");
    });
  };
  EXPECT_THROW(parallel_for(10, nested), std::runtime_error);
}

TEST(ParallelFor, HasNoMoreOuterCallsAtWorkThanThreads) {
  std::atomic<int> at_work = 0, most = 0;
  parallel_for(64, [&](std::size_t) {
    int now = ++at_work;
    for (int before = most; before < now && !most.compare_exchange_weak(before, now);) {
    }
    std::atomic<int> sum = 0;
    parallel_for(256, [&](std::size_t k) { sum += static_cast<int>(k); });
    EXPECT_EQ(sum, 255 * 128);
    --at_work;
  });
  EXPECT_LE(most, thread_count());
}

}  // namespace
}  // namespace frond
