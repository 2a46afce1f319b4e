#include "masonry/trellis.h"

#include <gtest/gtest.h>

#include "closed.h"
#include "core/bounds.h"
#include "solidity.h"

namespace frond {
namespace {

Bounds placed_bounds(const TrellisPart& part) {
  Bounds box;
  for (Vec3 p : part.surface.position) box.extend(part.at + part.turn * p);
  return box;
}

TEST(Trellis, IsMadeOfClosedParts) {
  for (TrellisForm form : {TrellisForm::wires, TrellisForm::lattice, TrellisForm::fan}) {
    TrellisShape shape;
    shape.form = form;
    for (const TrellisPart& part : trellis_parts(shape)) {
      EXPECT_EQ(solidity(part.surface).open, 0u);
      EXPECT_GT(volume_of(part.surface), 0) << "turned outward";
      EXPECT_NEAR(placed_bounds(part).middle().x, 0, shape.width / 2 + shape.post);
      EXPECT_LE(placed_bounds(part).high.y, shape.height + shape.lath);
    }
  }
}

TEST(Trellis, WiresRunBeforeTheirPostsAndSagBetweenThem) {
  TrellisShape shape;
  shape.sag = 0.05;
  std::vector<TrellisPart> parts = trellis_parts(shape);
  ASSERT_EQ(parts.size(), 7u);
  Bounds post = placed_bounds(parts[0]), wire = placed_bounds(parts[3]);
  EXPECT_NEAR(post.low.x, -2.04, 1e-3);
  EXPECT_LT(post.low.y, -0.3f) << "in the ground";
  EXPECT_GT(wire.low.z, post.high.z);
  EXPECT_NEAR(wire.high.y, shape.lowest, shape.wire);
  EXPECT_NEAR(wire.low.y, shape.lowest - shape.sag, shape.wire);
}

}  // namespace
}  // namespace frond
