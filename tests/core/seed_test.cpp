#include "core/seed.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frond {
namespace {

TEST(Seed, IsAFunctionOfItsPathOnly) {
  Seed root{7};
  EXPECT_EQ(root.child("a", 1).bits(), root.child("a", 1).bits());
  EXPECT_NE(root.child("a", 1).bits(), root.child("a", 2).bits());
  EXPECT_NE(root.child("a").bits(), root.child("b").bits());
  EXPECT_NE(root.child("a").child("b").bits(), root.child("b").child("a").bits());
  EXPECT_NE(Seed{7}.child(0).bits(), Seed{8}.child(0).bits());
}

TEST(Seed, KeepsItsNumbersFromVersionToVersion) {
  // Written down once: a change here changes every picture ever made.
  EXPECT_EQ(Seed{1}.bits(), 9348453635268248851ull);
  EXPECT_EQ(Seed{1}.child("organism", 2).bits(), 790185132148161558ull);
}

TEST(Seed, UnitIsUniform) {
  double sum = 0, squares = 0;
  constexpr int kCount = 100'000;
  for (int i = 0; i < kCount; ++i) {
    double u = Seed{3}.child(static_cast<std::uint64_t>(i)).unit();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    sum += u;
    squares += u * u;
  }
  EXPECT_NEAR(sum / kCount, 0.5, 0.005);
  EXPECT_NEAR(squares / kCount, 1.0 / 3, 0.005);
}

TEST(Seed, NormalHasMeanZeroAndDeviationOne) {
  double sum = 0, squares = 0;
  constexpr int kCount = 100'000;
  for (int i = 0; i < kCount; ++i) {
    double x = Seed{5}.child(static_cast<std::uint64_t>(i)).normal();
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / kCount, 0, 0.015);
  EXPECT_NEAR(squares / kCount, 1, 0.02);
}

}  // namespace
}  // namespace frond
