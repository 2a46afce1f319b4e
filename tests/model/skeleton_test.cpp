#include "model/skeleton.h"

#include <gtest/gtest.h>

#include "shapes.h"

namespace frond {
namespace {

TEST(Skeleton, MeasuresAlongTheBranches) {
  Skeleton s = trunk(3, 2);
  auto side = s.add(Vec3(0.5f, 1, 0), 0.1f, 1, 1);
  EXPECT_FLOAT_EQ(s.distance[side], 1.5f);
  EXPECT_FLOAT_EQ(s.longest(), 2);
  set_tip_distances(s);
  EXPECT_FLOAT_EQ(s.to_tip[0], 2);
  EXPECT_FLOAT_EQ(s.to_tip[1], 1);
  EXPECT_FLOAT_EQ(s.to_tip[side], 0);
  set_births(s);
  EXPECT_FLOAT_EQ(s.birth[1], 0.5f);
  EXPECT_FLOAT_EQ(s.birth[2], 1);
  EXPECT_EQ(s.find_fault(), "");
}

TEST(Skeleton, ChecksItself) {
  Skeleton s = trunk(4);
  s.radius[2] = 0;
  EXPECT_EQ(s.find_fault(), "node 2 has radius 0");
  s = trunk(4);
  s.parent[1] = 3;
  EXPECT_EQ(s.find_fault(), "node 1 has parent 3, which does not precede it");
  s = trunk(4);
  s.birth[3] = 0.1f;
  EXPECT_EQ(s.find_fault(), "node 3 is born before its parent 2");
}

}  // namespace
}  // namespace frond
