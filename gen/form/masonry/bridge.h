#pragma once

#include <vector>

#include "core/seed.h"
#include "masonry/arch.h"
#include "model/surface.h"

namespace frond {

enum class BridgeStyle { wood, stone };

/// A humped garden bridge along x over the origin, its feet at y = 0. Metres.
struct BridgeShape {
  BridgeStyle style = BridgeStyle::wood;
  double length = 10, width = 3, height = 1.5;  ///< overall; height of the deck at mid-span
  double crown = 0;                             ///< see Arch, 0.1 .. 0.5; 0: by the seed
  double thickness = 0.28;    ///< of the deck at mid-span; clamped to 0.8 of the arch's least radius
  int posts = 6;              ///< number per railing on each half, at least 1
  double post = 0.12;         ///< width of a post
  double rail_height = 0.95;  ///< top of the hand rail above the deck
  double rail = 0.09;         ///< width of the hand rail
  double lower_rail = 0.16;   ///< middle of the lower rail above the deck; 0: no lower rail
  int balusters = 0;          ///< number of thin bars between two posts
  double plank = 0.15;        ///< width of a plank, length of a paving stone
  double gap = 0.008;         ///< between planks, or between stones
  double foundation = 0.6;    ///< metres that it reaches below its feet
};

/// The role of a piece of a bridge.
enum class BridgePart {
  plank,       ///< of the deck: a board across, a paving stone
  stringer,    ///< under the planks
  post,        ///< of the railing: upright
  cap,         ///< on a post
  hand_rail,   ///< follows the arch; the coping of a stone bridge
  lower_rail,  ///< follows the arch; the course at the deck's height of a stone bridge
  baluster,
  voussoir,  ///< a wedge of the arch
  wall,      ///< between voussoirs and deck, and the parapet
  core       ///< the mortar that all stones sit in
};

/// A piece in its own axes, which its grain follows: x is the longest side of wooden pieces.
struct BridgePiece {
  BridgePart part = BridgePart::plank;
  Surface surface;  ///< closed; without `uv`
  Vec3 at{0};
  Quat turn{1, 0, 0, 0};
};

struct Bridge {
  Arch arch;
  double thickness = 0;  ///< actual thickness
  std::vector<BridgePiece> pieces;
};

/// Builds it. Posts stand upright at equal distances along the arch, including mid-span; hand rails and lower
/// rails follow it at their height. The same shape and seed give the same bridge.
Bridge build_bridge(const BridgeShape& shape, Seed seed);

/// Positions of the posts of one railing, in metres along the arch from mid-span, from one foot to the other.
std::vector<double> post_stations(const Arch& arch, const BridgeShape& shape);

}  // namespace frond
