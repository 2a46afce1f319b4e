#pragma once

#include <functional>
#include <vector>

#include "core/seed.h"
#include "core/vec.h"

// Growth at a margin
// ==================
// Leafy, crusting and tubular colonies grow at their rim alone; what lies inside is skeleton and never moves
// again. A sheet is laid row by row: the rim moves outward by a step, bears vertices where it is stretched
// and loses some where it shrinks. A rim that grows longer than a flat sheet has room for buckles into
// ruffles (Sharon et al. 2002; Klein et al. 2007). Here the rim alone is relaxed, as an elastic curve on the
// skeleton that is there (position based dynamics: Mueller et al. 2007).

namespace frond {

/// How rims grow. Lengths in metres.
struct Margin {
  double reach = 0.2;      ///< of the sheet from its start to its rim, along it, > 0
  double edge = 0.006;     ///< from vertex to vertex, > 0
  double excess = 1;       ///< how many times longer the rim comes to be than that of a flat sheet, >= 1
  double ruffle = 0.05;    ///< about from one fold to the next
  double stiffness = 0.3;  ///< how hard it is to fold: 0 .. 1
  double pitch = 1;        ///< radians above the horizon that it turns to as it grows
  double light = 0.5;      ///< how fast it does: radians over its reach, about
  double lobes = 0.2;      ///< how uneven the rim's pace is: 0 .. 1
  double lobe_size = 0.06;
  double clearance = 0.016;  ///< that parts of it keep from one another; at least 1.5 edges
};

/// Where a sheet begins.
struct MarginStart {
  std::vector<Vec3> rim;      ///< about an edge from each other
  std::vector<Vec3> heading;  ///< the way each one grows, of length 1
  bool closed = false;        ///< the last of the rim is followed by the first
  bool filled = false;        ///< what a closed rim surrounds belongs to the sheet
  float from_middle = 0;      ///< metres from where all its threads come from to the rim
  double begins = 0;          ///< the share of growth after which it starts
  double reach = 1;           ///< factor of that of the law, <= 1 - begins
};

/// What sheets have round them, in their own space.
struct MarginWorld {
  /// Metres that are free from a place on, at least.
  std::function<float(Vec3 at, float within)> room;
  /// Where a place is to lie and what is outward there, for sheets that cling; empty: they stand free.
  std::function<void(Vec3& at, Vec3& normal)> cling;
};

/// A surface without thickness.
struct Sheet {
  std::vector<Vec3> position;
  std::vector<Vec3> normal;
  std::vector<std::array<std::uint32_t, 3>> triangle;
  /// Of each vertex the ones that it grew from, itself for those of the start; they precede it.
  std::vector<std::array<std::uint32_t, 2>> parents;
  std::vector<float> row;       ///< that it was laid in; those of the start when it began
  std::vector<float> end;       ///< of each vertex, the last row that came of it
  std::vector<float> distance;  ///< from the middle, along the sheet
  int rows = 1;                 ///< in all
};

/// Grows sheets together, none through another; a pure function.
Sheet grow_margins(const Margin& law, const std::vector<MarginStart>& starts, const MarginWorld& world,
                   Seed seed);

}  // namespace frond
