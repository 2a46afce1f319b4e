#include "geometry/far.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foliage/sprig.h"

namespace frond {
namespace {

/// A stem of 41 nodes that bends, with a thin twig in its middle and a thick bough above it.
Skeleton tree() {
  Skeleton s;
  for (int i = 0; i <= 40; ++i)
    s.add(Vec3(0.2 * std::sin(i * 0.1), i * 0.1, 0), static_cast<float>(0.1 - i * 0.002), i - 1, 0);
  std::int32_t below = 20;
  for (int i = 1; i <= 5; ++i) below = s.add(Vec3(0.1 * i, 2, 0), 0.002f, below, 1);
  below = 30;
  for (int i = 1; i <= 5; ++i) below = s.add(Vec3(0, 3, 0.1 * i), 0.03f, below, 1);
  return s;
}

TEST(Thinned, KeepsWithinItsTolerance) {
  Skeleton s = tree(), far = thinned(s, 0, 0.01f);
  EXPECT_EQ(far.find_fault(), "");
  EXPECT_LT(far.size(), s.size() / 2);
  // Each node that is gone lies near a segment that is left.
  for (const Vec3& p : s.position) {
    float nearest = 1e9f;
    for (std::size_t i = 0; i < far.size(); ++i) {
      Vec3 a = far.position[i],
           b = far.parent[i] < 0 ? a : far.position[static_cast<std::size_t>(far.parent[i])];
      float t = a == b ? 0 : std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0f, 1.0f);
      nearest = std::min(nearest, glm::distance(p, a + (b - a) * t));
    }
    EXPECT_LE(nearest, 0.0101f);
  }
}

TEST(Thinned, LeavesOutWhatIsThin) {
  Skeleton far = thinned(tree(), 0.01f, -1);
  for (std::size_t i = 0; i < far.size(); ++i) EXPECT_GE(far.radius[i], 0.01f);
  EXPECT_EQ(far.size(), 46u) << "the stem and the bough";
  EXPECT_EQ(thinned(tree(), 0, -1).size(), tree().size());
}

TEST(Thinned, KeepsTheStem) { EXPECT_GE(thinned(tree(), 10, 0).size(), 41u); }

TEST(Diamonds, KeepAreaAndLengthOfEachLeaf) {
  for (SprigKind kind :
       {SprigKind::oval, SprigKind::lobed, SprigKind::narrow, SprigKind::needles, SprigKind::feather}) {
    SprigShape shape;
    shape.kind = kind;
    Surface sprig = sprig_surface(shape);
    Pieces pieces = pieces_of(sprig);
    Surface far = far_leaves(sprig, pieces);
    EXPECT_EQ(far.find_fault(), "");
    EXPECT_GE(pieces.count, static_cast<std::uint32_t>(shape.leaves));
    EXPECT_EQ(far.triangle.size(), 2 * pieces.count);
    EXPECT_NEAR(area(far), area(sprig), 0.05 * area(sprig));
    Surface fewer = far_leaves(sprig, pieces, 3);
    EXPECT_NEAR(area(fewer), area(sprig), 0.35 * area(sprig));
    EXPECT_LT(fewer.triangle.size(), far.triangle.size() / 2);
  }
}

TEST(Diamonds, FaceAsTheLeafDoes) {
  Surface leaf;
  leaf.position = {{0, 0, 0}, {0.3f, 0.5f, 0}, {0, 1, 0}, {-0.3f, 0.5f, 0}};
  leaf.triangle = {{0, 1, 2}, {0, 2, 3}};
  set_normals(leaf);
  Surface far = far_leaves(leaf, pieces_of(leaf));
  ASSERT_EQ(far.triangle.size(), 2u);
  for (auto [a, b, c] : far.triangle)
    EXPECT_GT(glm::cross(far.position[b] - far.position[a], far.position[c] - far.position[a]).z, 0);
  EXPECT_GT(far.normal[0].z, 0.99f);
}

TEST(Diamonds, OneStandsForAll) {
  Surface sprig = sprig_surface({});
  Surface far = one_far_leaf(sprig, pieces_of(sprig));
  EXPECT_EQ(far.triangle.size(), 2u);
  EXPECT_NEAR(area(far), area(sprig), 0.05 * area(sprig));
  for (Vec2 uv : far.uv) EXPECT_EQ(uv, far.uv[0]);
}

}  // namespace
}  // namespace frond
