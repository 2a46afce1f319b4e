#pragma once

#include "core/seed.h"
#include "model/surface.h"

namespace frond {

/// A reef framework: dead colonies that have grown on one another over an older core, then bored and eroded.
struct Framework {
  double height = 0.55;   ///< share of the size, about
  int colonies = 150;     ///< number of dead colonies; the first are the largest
  double plates = 0.35;   ///< share of them that are plates: ledges on steep sides, tables on level tops
  double branches = 0.2;  ///< share of them that are stubs of branches; all others are domes
  double boring = 0.5;    ///< 0 massive .. 1: number of caves, holes and pits
  double erosion = 0.5;   ///< 0 as it grew .. 1: how rough it is worn
};

/// Of a framework or a fragment as a mesh.
struct FrameworkCells {
  double finest = 1.0 / 128;  ///< share of the size, least width of a cell
  double tolerance = 0.0003;  ///< share of the size that a small dome may be off
};

/// The framework as one closed piece: it stands on y = 0, cut flat, its longest side is `size`.
Surface framework_surface(const Framework& framework, double size, const FrameworkCells& cells, Seed seed);

/// A fragment of a branched coral as it lies in rubble: worn and pitted, its longest side is `size`, its
/// lowest place on y = 0. Of the framework only `erosion` counts.
Surface rubble_surface(const Framework& framework, double size, const FrameworkCells& cells, Seed seed);

}  // namespace frond
