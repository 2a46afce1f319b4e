#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/seed.h"
#include "core/vec.h"

namespace frond {

struct LeafOutline;  // images/leaf.h

/// Where the main veins of a blade run: from a midrib, from the stalk to the lobes, side by side from the
/// stalk to the tip, or forking again and again.
enum class VeinPattern : std::uint8_t { pinnate, palmate, parallel, dichotomous };

/// How a blade is veined.
struct Venation {
  VeinPattern pattern = VeinPattern::pinnate;
  int secondaries = 8;  ///< on either side of a midrib as long as the blade; each lobe has its own
  double density = 1;   ///< factor of how close the veins of third and higher order are
  bool loops = true;    ///< whether veins join again and enclose areoles; dichotomous ones never do
  bool to_rim = false;  ///< secondaries reach a rim without teeth instead of arching to the next one
  double angle = 0.87;  ///< between midrib and secondaries in the middle of the blade, radians
};

/// The veins of a blade, in the unit of its leaf: the foot of the stalk at the origin, the tip at (0, 1).
struct Veins {
  std::vector<Vec2> point;  ///< the first is where the stalk ends
  std::vector<std::int32_t>
      parent;                ///< a vein runs to each point from its parent, which precedes it; -1: none
  std::vector<float> width;  ///< half of it, in the leaf's unit
  std::vector<std::uint8_t> order;  ///< 1 main veins, 2 secondaries, 3 and more the veins between them
  std::vector<std::array<std::uint32_t, 2>> joins;  ///< what closes loops: more veins between two points

  std::size_t size() const { return point.size(); }
};

/// Grows the veins of a blade. The main veins and secondaries are laid by the pattern, and end in lobes and
/// teeth where there are some. All others grow toward sources of auxin (Runions et al. 2005): sources lie
/// where no vein is near, ever closer from round to round, which stands for the growth of the blade between
/// them; each attracts the nearest vein, or with `loops` all that are its relative neighbours, until they
/// arrive. Widths follow the pipe model: the cube of a vein's is the sum of those of the veins that it feeds.
/// `finest`: no vein is grown for sources closer than that, in the leaf's unit, 0.01 or more.
Veins grow_veins(const LeafOutline& outline, double finest, Seed seed);

/// A secondary of a blade, straightened: where it leaves its midrib and where it ends.
struct SecondaryLine {
  Vec2 from{0}, to{0};
};

/// Those of a pinnate blade from its foot to its tip, of both sides; none for other patterns.
std::vector<SecondaryLine> secondary_lines(const LeafOutline& outline);

}  // namespace frond
