#pragma once

#include "masonry/block.h"
#include "masonry/bridge.h"

// Parts of wooden and stone bridges; see bridge.h.

namespace frond {

inline float real(double x) { return static_cast<float>(x); }

/// A bar along an arch, from `from` to `to` metres along it, with a section from `low` to `high` across it
/// and from `near` to `far` sideways.
struct Bar {
  double from, to, low, high, near, far;
  float bevel = 0.01f;
  int cuts = 1;          ///< subdivisions along it
  int sides = 1;         ///< subdivisions of each side
  bool upright = false;  ///< heights and ends are vertical, not at right angles to the arch
};

/// The bar in world axes.
Surface bar_surface(const Arch& arch, const Bar& bar);

/// The bar as a piece along its own chord.
BridgePiece bar_piece(const Arch& arch, BridgePart part, const Bar& bar);

/// A piece from a mesh in world axes, rotated by `turn` about `at`.
BridgePiece piece_of(BridgePart part, Surface world, Vec3 at, Quat turn);

/// An upright post whose middle is at (x, z), from y = foot to head.
BridgePiece post_piece(Vec2 at, double foot, double head, double width, float bevel);

/// A cap with four slopes on a post whose top is at y = head.
BridgePiece cap_piece(Vec2 at, double head, double width);

/// Displaces the surface of stones by up to `depth` with noise of the given size; metres.
void roughen(Surface& surface, float depth, float size, Seed seed);

void build_stone(const BridgeShape& shape, Bridge& bridge, Seed seed);

}  // namespace frond
