#include "core/loop.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

TEST(Loop, HoldsWholeTurnsAndAtLeastOne) {
  EXPECT_EQ(looping_rate(0.3, 10), 0.3);
  EXPECT_EQ(looping_rate(0.34, 10), 0.3);
  EXPECT_EQ(looping_rate(0.01, 10), 0.1);
  EXPECT_EQ(looping_rate(0.01, 0), 0.01) << "nothing repeats";
  EXPECT_EQ(whole_turns(0.36, 10), 4);
}

}  // namespace
}  // namespace frond
