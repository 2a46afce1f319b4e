#pragma once

#include "masonry/block.h"
#include "masonry/bridge.h"

// What wooden and stone bridges are put together from; see bridge.h.

namespace frond {

inline float real(double x) { return static_cast<float>(x); }

/// A bar along an arch: from `from` to `to` metres along it, with a section that reaches across from `low` to
/// `high` and sideways from `near` to `far`.
struct Bar {
  double from, to, low, high, near, far;
  float bevel = 0.01f;
  int cuts = 1;          ///< along it
  int sides = 1;         ///< across each side
  bool upright = false;  ///< heights and ends are upright, not square to the arch
};

/// The bar in world axes.
Surface bar_surface(const Arch& arch, const Bar& bar);

/// The bar as a piece along its own chord.
BridgePiece bar_piece(const Arch& arch, BridgePart part, const Bar& bar);

/// A piece from a mesh in world axes, turned by `turn` about `at`.
BridgePiece piece_of(BridgePart part, Surface world, Vec3 at, Quat turn);

/// An upright post whose middle is at (x, z), from y = foot to head.
BridgePiece post_piece(Vec2 at, double foot, double head, double width, float bevel);

/// A cap with four slopes on a post whose head is at y = head.
BridgePiece cap_piece(Vec2 at, double head, double width);

/// Moves the skin of stones in and out by up to `depth`, by noise of the given size; metres.
void roughen(Surface& surface, float depth, float size, Seed seed);

void build_wooden(const BridgeShape& shape, Bridge& bridge, Seed seed);
void build_stone(const BridgeShape& shape, Bridge& bridge, Seed seed);

}  // namespace frond
