#include "masonry/bridge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "masonry/block.h"
#include "solidity.h"

namespace frond {
namespace {

Vec3 placed(const BridgePiece& piece, Vec3 p) { return piece.at + piece.turn * p; }

struct Box {
  Vec3 low{std::numeric_limits<float>::max()}, high{std::numeric_limits<float>::lowest()};
  void add(Vec3 p) { low = glm::min(low, p), high = glm::max(high, p); }
};

Box box_of(const BridgePiece& piece) {
  Box box;
  for (const Vec3& p : piece.surface.position) box.add(placed(piece, p));
  return box;
}

/// Bridges of both styles, flat and humped, narrow and wide.
std::vector<BridgeShape> shapes() {
  std::vector<BridgeShape> all;
  for (BridgeStyle style : {BridgeStyle::wood, BridgeStyle::stone})
    for (double crown : {0.1, 0.22, 0.35, 0.5})
      for (double height : {0.2, 1.5, 3.0}) {
        BridgeShape shape;
        shape.style = style, shape.crown = crown, shape.height = height;
        shape.length = height == 3.0 ? 6 : 10, shape.width = height == 0.2 ? 1.2 : 3;
        shape.balusters = height == 3.0 ? 2 : 0;
        shape.posts = height == 3.0 ? 2 : 6;
        all.push_back(shape);
      }
  return all;
}

TEST(Bridge, EachPieceIsAClosedBodyTurnedOutward) {
  for (const BridgeShape& shape : shapes()) {
    Bridge bridge = build_bridge(shape, Seed{3});
    EXPECT_GT(bridge.pieces.size(), 60u);
    for (const BridgePiece& piece : bridge.pieces) {
      ASSERT_EQ(piece.surface.find_fault(), "");
      Solidity solid = solidity(piece.surface);
      ASSERT_EQ(solid.open, 0u) << static_cast<int>(piece.part) << " height " << shape.height;
      ASSERT_EQ(solid.euler, 2) << static_cast<int>(piece.part);
      ASSERT_GT(volume(piece.surface), 1e-6)
          << static_cast<int>(piece.part) << " height " << shape.height << " crown " << shape.crown
          << " style " << static_cast<int>(shape.style);
    }
  }
}

TEST(Bridge, PostsAreUprightOnTheArchAtEvenWays) {
  for (const BridgeShape& shape : shapes()) {
    Bridge bridge = build_bridge(shape, Seed{3});
    std::vector<double> stations = post_stations(bridge.arch, shape);
    ASSERT_EQ(stations.size(), 2u * static_cast<std::size_t>(shape.posts));
    for (std::size_t i = 2; i < stations.size(); ++i)
      EXPECT_NEAR(stations[i] - stations[i - 1], stations[1] - stations[0], 1e-9);
    std::size_t posts = 0;
    for (const BridgePiece& piece : bridge.pieces) {
      if (piece.part != BridgePart::post) continue;
      // In the order of their stations, first one side, then the other.
      glm::dvec2 on = arch_at(bridge.arch, stations[posts++ % stations.size()]).at;
      Vec3 up = piece.turn * Vec3(1, 0, 0);
      EXPECT_NEAR(up.y, 1, 1e-6);
      EXPECT_NEAR(piece.at.x, on.x, 1e-5);
      Box box = box_of(piece);
      EXPECT_LT(box.low.y, arch_height(bridge.arch, piece.at.x) + 1e-5) << "it hangs in the air";
      EXPECT_GE(box.high.y, on.y + shape.rail_height) << "it ends below the hand rail";
      EXPECT_NEAR((box.low.x + box.high.x) / 2, on.x, 1e-4);
    }
    EXPECT_EQ(posts, 4u * static_cast<std::size_t>(shape.posts));
  }
}

TEST(Bridge, HandRailsFollowTheArch) {
  for (const BridgeShape& shape : shapes()) {
    Bridge bridge = build_bridge(shape, Seed{3});
    double reach = 0, lowest_gap = 1e9;
    for (const BridgePiece& piece : bridge.pieces) {
      if (piece.part != BridgePart::hand_rail) continue;
      double highest = -1e9;
      for (const Vec3& p : piece.surface.position) {
        Vec3 at = placed(piece, p);
        reach = std::max(reach, std::abs(double(at.x)));
        if (std::abs(at.x) > shape.length / 2) continue;
        // Above the arch, as it is seen across it; stones are rough by some millimetres.
        double x = at.x, up = arch_height(bridge.arch, x),
               slope = (arch_height(bridge.arch, x + 1e-3) - arch_height(bridge.arch, x - 1e-3)) / 2e-3;
        double above = shape.rail_height + (at.y - up - shape.rail_height) / std::hypot(1.0, slope);
        EXPECT_LT(above, shape.rail_height + 0.007);
        highest = std::max(highest, above);
        lowest_gap = std::min(lowest_gap, above);
      }
      EXPECT_GT(highest, shape.rail_height - 0.007);
    }
    EXPECT_GT(lowest_gap, shape.rail_height - 0.14);
    EXPECT_GT(reach, 0.9 * shape.length / 2);
  }
}

TEST(Bridge, TheDeckHasItsWidthAndThickness) {
  for (const BridgeShape& shape : shapes()) {
    Bridge bridge = build_bridge(shape, Seed{3});
    EXPECT_LE(bridge.thickness, shape.thickness);
    EXPECT_LE(bridge.thickness, 0.81 * least_radius(bridge.arch));
    if (shape.crown < 0.5) {
      EXPECT_NEAR(bridge.thickness, std::min(shape.thickness, 0.8 * least_radius(bridge.arch)), 1e-9);
    }
    Box deck;
    double top = -1e9, under = -1e9;
    for (const BridgePiece& piece : bridge.pieces) {
      bool wood = shape.style == BridgeStyle::wood;
      if (piece.part == BridgePart::plank || (!wood && piece.part == BridgePart::lower_rail))
        for (const Vec3& p : piece.surface.position) deck.add(placed(piece, p));
      for (const Vec3& p : piece.surface.position) {
        Vec3 at = placed(piece, p);
        if (std::abs(at.x) > (wood ? 0.5 : 0.1)) continue;
        double x = at.x, below = arch_height(bridge.arch, x) - at.y,
               slope = (arch_height(bridge.arch, x + 1e-3) - arch_height(bridge.arch, x - 1e-3)) / 2e-3;
        if (piece.part == BridgePart::plank && std::abs(x) < 0.1) top = std::max(top, -below);
        if (piece.part == (wood ? BridgePart::stringer : BridgePart::voussoir))
          under = std::max(under, below / std::hypot(1.0, slope));
      }
    }
    EXPECT_NEAR(deck.high.z - deck.low.z, shape.width, 0.02);
    EXPECT_NEAR(deck.high.x - deck.low.x, shape.length, 0.12) << shape.height << ' ' << shape.crown;
    EXPECT_NEAR(top, 0, 0.012) << shape.crown << ' ' << shape.height;
    if (shape.height > 0.5 && (shape.style == BridgeStyle::wood || least_radius(bridge.arch) > 1)) {
      EXPECT_NEAR(under, bridge.thickness, 0.025)
          << shape.height << ' ' << shape.crown << ' ' << static_cast<int>(shape.style);
    }
  }
}

TEST(Bridge, NoPlankLiesInTheNext) {
  BridgeShape shape;
  shape.crown = 0.25;
  Bridge bridge = build_bridge(shape, Seed{3});
  std::vector<Box> planks;
  for (const BridgePiece& piece : bridge.pieces)
    if (piece.part == BridgePart::plank) planks.push_back(box_of(piece));
  EXPECT_GT(planks.size(), 60u);
  EXPECT_LT(planks.size(), 80u);
  for (std::size_t i = 1; i < planks.size(); ++i) {
    double middles = (planks[i].low.x + planks[i].high.x - planks[i - 1].low.x - planks[i - 1].high.x) / 2;
    EXPECT_GT(middles, 0.12) << i;
    EXPECT_LT(middles, 0.17) << i;
  }
}

TEST(Bridge, TheSeedPicksTheCrownAndNothingElseOfTheLine) {
  BridgeShape shape;
  double least = 1, most = 0;
  for (std::uint64_t i = 0; i < 40; ++i) {
    Arch arch = build_bridge(shape, Seed{i}).arch;
    least = std::min(least, arch.crown), most = std::max(most, arch.crown);
    EXPECT_NEAR(arch_height(arch, 0), shape.height, 1e-12);
  }
  EXPECT_GE(least, 0.1);
  EXPECT_LE(most, 0.5);
  EXPECT_GT(most - least, 0.3);
}

TEST(Bridge, TheSameSeedGivesTheSameBridge) {
  BridgeShape shape;
  Bridge a = build_bridge(shape, Seed{8}), b = build_bridge(shape, Seed{8}), c = build_bridge(shape, Seed{9});
  ASSERT_EQ(a.pieces.size(), b.pieces.size());
  for (std::size_t i = 0; i < a.pieces.size(); ++i)
    EXPECT_EQ(a.pieces[i].surface.position, b.pieces[i].surface.position);
  EXPECT_NE(a.pieces[3].surface.position, c.pieces[3].surface.position);
}

TEST(Arch, BothHalvesMirrorEachOther) {
  for (double crown : {0.1, 0.3, 0.5}) {
    Arch arch = make_arch(10, 1.5, crown);
    for (double s = 0; s <= half_length(arch) + 0.5; s += 0.13) {
      ArchPoint right = arch_at(arch, s), left = arch_at(arch, -s);
      EXPECT_NEAR(right.at.x, -left.at.x, 1e-12);
      EXPECT_NEAR(right.at.y, left.at.y, 1e-12);
      EXPECT_NEAR(right.along.x, left.along.x, 1e-12);
      EXPECT_NEAR(right.along.y, -left.along.y, 1e-12);
    }
    EXPECT_NEAR(arch_at(arch, half_length(arch)).at.x, 5, 1e-9);
    EXPECT_NEAR(arch_at(arch, half_length(arch)).at.y, 0, 1e-9);
  }
}

TEST(Arch, IsSmoothAtMidSpan) {
  for (double crown : {0.1, 0.3, 0.5}) {
    Arch arch = make_arch(10, 1.5, crown);
    ArchPoint left = arch_at(arch, -1e-6), right = arch_at(arch, 1e-6);
    EXPECT_LT(glm::distance(left.at, right.at), 1e-5);
    EXPECT_LT(glm::distance(left.along, right.along), 1e-4);
    EXPECT_NEAR(right.along.y, 0, 1e-4);
  }
}

TEST(Arch, WaysAreLengthsAndHeightsLieOnIt) {
  for (double crown : {0.1, 0.25, 0.5}) {
    Arch arch = make_arch(10, 1.5, crown);
    double half = half_length(arch);
    for (double s = -half; s < half - 0.01; s += 0.01)
      EXPECT_NEAR(glm::distance(arch_at(arch, s).at, arch_at(arch, s + 0.01).at), 0.01, 2e-5);
    for (double s = -half; s <= half; s += 0.05) {
      glm::dvec2 at = arch_at(arch, s).at;
      EXPECT_NEAR(arch_height(arch, at.x), at.y, crown == 0.5 ? 1e-5 : 1e-8) << s;
    }
  }
}

TEST(Block, IsARoundedBox) {
  Block block{Vec3(2, 1, 0.5f), 0.1f, {3, 2, 1}};
  Surface s = block_surface(block);
  EXPECT_EQ(s.find_fault(), "");
  EXPECT_EQ(solidity(s).open, 0u);
  EXPECT_EQ(solidity(s).euler, 2);
  EXPECT_LT(volume(s), 1.0);
  EXPECT_GT(volume(s), 0.9);
  for (const Vec3& p : s.position) {
    EXPECT_LE(std::abs(p.x), 1 + 1e-6f);
    EXPECT_LE(std::abs(p.y), 0.5f + 1e-6f);
    EXPECT_LE(std::abs(p.z), 0.25f + 1e-6f);
  }
}

}  // namespace
}  // namespace frond
