#include "organisms/colonized/colonized.h"

#include <gtest/gtest.h>

#include <cmath>

#include "organisms/weber_penn/weber_penn.h"

namespace frond {
namespace {

WeberPennParams aspen() {
  WeberPennParams p;
  p.tree.scale = 6;
  p.tree.levels = 2;
  p.tree.level[0].length = 1;
  p.tree.level[1].branches = 12;
  p.tree.level[1].down_angle = radians(60.0);
  p.tree.leaves = 9;
  p.tree.leaf_scale = 0.1;
  p.tree.leaf_scale_x = 0.8;
  p.appearance.leaves.size_variation = 0;
  return p;
}

TEST(CrownTree, WeberPennLeavesAreAsLargeAsTheirParametersSay) {
  WeberPennParams p = aspen();
  Result<Model> model = grow_weber_penn_tree(p, Seed{1});
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model->find_fault(), "");
  ASSERT_GT(model->organs.size(), 50u);
  const Surface& leaf = model->prototypes[0].parts[0].surface;
  float wide = 0, high = 0;
  for (Vec3 v : leaf.position) {
    wide = std::max(wide, std::abs(v.x));
    high = std::max(high, v.y);
  }
  Vec3 scale = model->organs.scale[0];
  EXPECT_NEAR(2 * wide * scale.x, 0.08, 0.004);
  EXPECT_NEAR(scale.y, 0.1, 1e-6);
  EXPECT_GT(high, 0.9f);
}

TEST(CrownTree, ColonizedTreesFillTheirEnvelopeAndCarryWhatTheyBear) {
  ColonizedParams p;
  p.growth_into.attractors = 1500;
  p.smoothing = 2;
  p.thickness.flare = 0;
  p.thickness.least = 0.00001;
  Result<Model> model = grow_colonized_tree(p, Seed{4});
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model->find_fault(), "");
  const Skeleton& s = model->skeleton;
  for (Vec3 at : s.position)
    EXPECT_LT(glm::length((at - Vec3(0, 3.2f, 0)) / Vec3(1.8f, 2, 1.8f)), at.y > 1.4f ? 1.2f : 9.0f);
  EXPECT_NEAR(s.radius[0], p.thickness.radius, 1e-5);
  // The pipe model: what a fork carries is the sum of its branches.
  std::vector<double> sum(s.size(), 0);
  for (std::size_t i = 1; i < s.size(); ++i) sum[s.parent[i]] += std::pow(s.radius[i], p.thickness.exponent);
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (sum[i] > 0) {
      EXPECT_NEAR(sum[i] / std::pow(s.radius[i], p.thickness.exponent), 1, 1e-3);
    }
  }
  EXPECT_GT(model->organs.size(), 300u);
}

TEST(CrownTree, AnEnvelopeWithoutItsShapeIsRefused) {
  ColonizedParams p;
  p.envelope.kind = EnvelopeKind::outline;
  EXPECT_FALSE(check_colonized(p).empty());
  p.envelope.path = "M0 0 L10 0 L5 10";
  EXPECT_TRUE(check_colonized(p).empty());
  p.envelope.path = "M0 0 L10";
  EXPECT_FALSE(check_colonized(p).empty());
  p.envelope.kind = EnvelopeKind::mesh;
  EXPECT_FALSE(check_colonized(p).empty());
}

TEST(CrownTree, PicturesAreNamedByWhatIsInThem) {
  WeberPennParams p = aspen();
  p.appearance.leaves.pixels = 32;
  p.appearance.coat.emplace();
  p.appearance.coat->pixels = 32;
  auto pictures = [](const TreeAppearance& appearance) -> Result<std::vector<Picture>> {
    std::vector<Picture> all;
    for (const Drawing& drawing : drawings(tree_appearance(appearance, true).look)) {
      Result<std::vector<Picture>> drawn = drawing.draw();
      if (!drawn) return drawn;
      EXPECT_EQ(drawn->size(), drawing.names.size());
      for (std::size_t i = 0; i < drawn->size(); ++i) EXPECT_EQ((*drawn)[i].name, drawing.names[i]);
      all.insert(all.end(), drawn->begin(), drawn->end());
    }
    return all;
  };
  Result<std::vector<Picture>> first = pictures(p.appearance);
  ASSERT_TRUE(first.ok());
  ASSERT_EQ(first->size(), p.appearance.leaves.colors.size() + 2);
  // A frame names just those.
  EXPECT_EQ(leaf_prototype(p.appearance.leaves).parts[0].pictures[1], (*first)[1].name);
  EXPECT_EQ(bark_color_name(*p.appearance.coat), (*first)[3].name);
  Result<std::vector<Picture>> again = pictures(p.appearance);
  EXPECT_EQ((*again)[0].bytes, (*first)[0].bytes);
  p.appearance.leaves.shape = LeafShape::oak;
  p.appearance.coat->image.ridges += 1;
  Result<std::vector<Picture>> other = pictures(p.appearance);
  for (std::size_t i = 0; i < first->size(); ++i) {
    EXPECT_NE((*other)[i].name, (*first)[i].name);
    EXPECT_NE((*other)[i].bytes, (*first)[i].bytes);
  }
}

}  // namespace
}  // namespace frond
