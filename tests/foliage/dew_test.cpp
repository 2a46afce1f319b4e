#include "foliage/dew.h"

#include <gtest/gtest.h>

#include "foliage/organ_shapes.h"

namespace frond {
namespace {

TEST(Dew, DropsLieOnTheUpperSideApartFromEachOther) {
  Surface leaf;
  leaf.position = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  leaf.triangle = {{0, 1, 2}, {0, 2, 3}};
  set_normals(leaf);
  // A leaf of 5 cm: 25 square centimetres.
  Surface dew = dew_surface(leaf, 0.05, 4, Seed{1});
  std::size_t drops = dew.position.size() / ball_surface().position.size();
  EXPECT_GT(drops, 70u);
  EXPECT_LE(drops, 100u);
  for (const Vec3& p : dew.position) EXPECT_GT(p.z, -0.0005f / 0.05f);
  EXPECT_TRUE(dew.find_fault().empty()) << dew.find_fault();
  EXPECT_TRUE(dew_surface(leaf, 0.05, 0, Seed{1}).triangle.empty());
  EXPECT_EQ(dew_surface(leaf, 0.05, 4, Seed{1}).position, dew.position);
}

}  // namespace
}  // namespace frond
