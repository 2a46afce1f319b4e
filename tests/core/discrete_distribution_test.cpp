#include "core/discrete_distribution.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

TEST(DiscreteDistribution, AreDrawnByTheirShares) {
  DiscreteDistribution lots;
  EXPECT_EQ(lots.sum(), 0);
  for (double weight : {0.0, 3.0, 0.0, 1.0}) lots.add(weight);
  EXPECT_EQ(lots.sum(), 4);
  EXPECT_EQ(lots.drawn(0), 1u);
  EXPECT_EQ(lots.drawn(0.7499), 1u);
  EXPECT_EQ(lots.drawn(0.75), 3u);
  EXPECT_EQ(lots.drawn(1), 3u);
}

TEST(DiscreteDistribution, WithoutWeightTheLastIsDrawn) {
  DiscreteDistribution lots;
  lots.add(0), lots.add(0);
  EXPECT_EQ(lots.drawn(0.5), 1u);
}

}  // namespace
}  // namespace frond
