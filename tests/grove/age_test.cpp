#include "grove/age.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

TEST(Age, AYoungTreeGoesThroughItsCyclesAtAnEvenPace) {
  Species s;
  for (int years = 1; years <= 12; ++years) EXPECT_EQ(growth_cycles(s, years), years);
  s.pace = 0.5, s.youth = 24;
  EXPECT_EQ(growth_cycles(s, 1), 1) << "none has not grown at all";
  EXPECT_EQ(growth_cycles(s, 20), 10);
}

/// By the logarithm of its age: each doubling of it brings as many cycles.
TEST(Age, AnOldTreeTakesTheLongerForACycleTheOlderItIs) {
  Species s;
  s.youth = 10;
  EXPECT_EQ(growth_cycles(s, 20), 17);
  EXPECT_EQ(growth_cycles(s, 40), 24);
  EXPECT_EQ(growth_cycles(s, 80), 31);
  EXPECT_EQ(growth_cycles(s, 160), 38);
  for (int years = 1; years < 400; ++years)
    EXPECT_LE(growth_cycles(s, years), growth_cycles(s, years + 1)) << years;
}

TEST(Age, DeadWoodRotsByTheCalendar) {
  Species s;
  s.lifespan = 150;
  EXPECT_EQ(growth_cycles(s, 162), growth_cycles(s, 150) + 12);
}

TEST(Age, CountedInCyclesAYearIsOne) {
  Species s;
  s.maturity = 60, s.lifespan = 300;
  Species counted = in_cycles(s);
  EXPECT_EQ(counted.maturity, growth_cycles(s, 60));
  EXPECT_EQ(counted.lifespan, growth_cycles(s, 300));
  for (int cycles : {1, 7, 20, 43}) EXPECT_EQ(growth_cycles(counted, cycles), cycles);
}

}  // namespace
}  // namespace frond
