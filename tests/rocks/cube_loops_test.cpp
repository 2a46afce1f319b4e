#include "rocks/cube_loops.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

TEST(CubeLoops, CutEachCubeInClosedLoops) {
  for (unsigned inside = 0; inside < 256; ++inside) {
    int crossed = 0, steps = 0;
    for (auto [a, b] : CubeLoops::edges()) crossed += (inside >> a & 1) != (inside >> b & 1);
    for (const auto& loop : CubeLoops::table()[inside]) {
      EXPECT_GE(loop.size(), 3u);
      steps += static_cast<int>(loop.size());
    }
    EXPECT_EQ(crossed, steps) << inside;
  }
  EXPECT_EQ(CubeLoops::table()[0b10010110].size(), 4u);
}

}  // namespace
}  // namespace frond
