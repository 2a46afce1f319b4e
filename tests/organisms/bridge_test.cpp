#include "organisms/bridge/bridge.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "masonry/block.h"
#include "solidity.h"

namespace frond {
namespace {

TEST(BridgeModel, WoodenPiecesHaveTimberOfTheirOwn) {
  BridgeParams params;
  params.shape.crown = 0.25;
  Model model = grow_bridge(params, Seed{4});
  EXPECT_EQ(model.find_fault(), "");
  EXPECT_GT(model.solids.size(), 150u);
  EXPECT_EQ(model.skeleton.size(), 0u);
  std::vector<float> reds;
  for (const Solid& solid : model.solids.shapes) {
    EXPECT_EQ(solid.material.matter, Matter::timber);
    EXPECT_EQ(solidity(solid.surface).open, 0u);
    EXPECT_EQ(solidity(solid.surface).euler, 2);
    EXPECT_GT(volume(solid.surface), 0);
    reds.push_back(solid.material.color.red);
    // The pith, y = z = 0, lies outside the middle of each piece: rings show as a saw lays them bare.
    Vec3 middle(0);
    for (const Vec3& p : solid.surface.position)
      middle += p / static_cast<float>(solid.surface.position.size());
    EXPECT_GT(std::hypot(middle.y, middle.z), 0.02f);
  }
  auto [least, most] = std::minmax_element(reds.begin(), reds.end());
  EXPECT_GT(*most - *least, 0.08f) << "all of one tone";
  Surface all = merged(model.solids);
  float high = -9, low = 9, left = 9, right = -9;
  for (const Vec3& p : all.position)
    high = std::max(high, p.y), low = std::min(low, p.y), left = std::min(left, p.z),
    right = std::max(right, p.z);
  EXPECT_GT(high, 1.5f + 0.95f);
  EXPECT_LT(high, 1.5f + 1.3f);
  EXPECT_LT(low, -0.3f);
  EXPECT_NEAR(right - left, 3, 0.03);
}

TEST(BridgeModel, StonesOfOneToneAreOneBody) {
  BridgeParams params;
  params.shape.style = BridgeStyle::stone;
  params.shape.crown = 0.25, params.shape.thickness = 0.42;
  Model model = grow_bridge(params, Seed{4});
  EXPECT_EQ(model.find_fault(), "");
  EXPECT_LE(model.solids.shapes.size(), 8u);
  std::size_t mortar = 0;
  for (const Solid& solid : model.solids.shapes) {
    mortar += solid.material.matter == Matter::bed;
    EXPECT_GT(volume(solid.surface), 0);
  }
  EXPECT_EQ(mortar, 1u);
}

TEST(BridgeModel, TheSeedPicksOtherPlanks) {
  BridgeParams params;
  Model a = grow_bridge(params, Seed{1}), b = grow_bridge(params, Seed{1}), c = grow_bridge(params, Seed{2});
  EXPECT_EQ(a.solids.shapes[5].surface.position, b.solids.shapes[5].surface.position);
  EXPECT_NE(a.solids.shapes[5].surface.position, c.solids.shapes[5].surface.position);
}

}  // namespace
}  // namespace frond
