#pragma once

#include <functional>
#include <vector>

#include "core/seed.h"
#include "core/vec.h"

// Growth at a margin
// ==================
// Leafy, crusting and tubular colonies grow only at their rim; everything inside is skeleton and never moves
// again. A sheet is built row by row: the rim moves outward by one step, gets new vertices where it is
// stretched and loses some where it shrinks. A rim longer than a flat sheet has room for buckles into ruffles
// (Sharon et al. 2002; Klein et al. 2007). Here only the rim is relaxed, as an elastic curve on the existing
// skeleton (position based dynamics: Mueller et al. 2007).

namespace frond {

/// How rims grow. Lengths in metres.
struct Margin {
  double reach = 0.2;      ///< length of the sheet from its start to its rim, along it, > 0
  double edge = 0.006;     ///< from vertex to vertex, > 0
  double excess = 1;       ///< final length of the rim relative to that of a flat sheet, >= 1
  double ruffle = 0.05;    ///< about from one fold to the next
  double stiffness = 0.3;  ///< resistance to folding: 0 .. 1
  double pitch = 1;        ///< radians above the horizon toward which it turns as it grows
  double light = 0.5;      ///< how fast it turns so: radians over its reach, about
  double lobes = 0.2;      ///< how uneven the pace of the rim is: 0 .. 1
  double lobe_size = 0.06;
  double clearance = 0.016;  ///< distance that its parts keep from each other; at least 1.5 edges
};

/// Where a sheet begins.
struct MarginStart {
  std::vector<Vec3> rim;      ///< about an edge from each other
  std::vector<Vec3> heading;  ///< direction of growth of each, of length 1
  bool closed = false;        ///< the last vertex of the rim is followed by the first
  bool filled = false;        ///< the inside of a closed rim belongs to the sheet
  float from_middle = 0;      ///< metres to the rim from the common origin of all threads
  double begins = 0;          ///< share of growth after which it starts
  double reach = 1;           ///< factor of Margin::reach, <= 1 - begins
};

/// The surroundings of sheets, in their own space.
struct MarginWorld {
  /// A lower bound of the free distance from a point, metres.
  std::function<float(Vec3 at, float within)> room;
  /// The position and outward normal to which a point of a clinging sheet is moved; empty: sheets stand free.
  std::function<void(Vec3& at, Vec3& normal)> cling;
};

/// A surface without thickness.
struct Sheet {
  std::vector<Vec3> position;
  std::vector<Vec3> normal;
  std::vector<std::array<std::uint32_t, 3>> triangle;
  /// The two parents of each vertex (a vertex of the start is its own parent); parents precede it.
  std::vector<std::array<std::uint32_t, 2>> parents;
  std::vector<float> row;       ///< the row in which it was laid; at the start, when its sheet began
  std::vector<float> end;       ///< of each vertex, the last row that descends from it
  std::vector<float> distance;  ///< metres from the middle, along the sheet
  int rows = 1;                 ///< in all
};

/// Grows sheets together so that none crosses another; a pure function.
Sheet grow_margins(const Margin& law, const std::vector<MarginStart>& starts, const MarginWorld& world,
                   Seed seed);

}  // namespace frond
