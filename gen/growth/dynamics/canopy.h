#pragma once

#include <span>
#include <vector>

#include "dynamics/trees.h"

// The light in a stand. Leaves are spread evenly over crowns, which are paraboloids; light comes from the
// whole sky, loses by Beer's law what leaves take, and spreads to the sides as it comes down.

namespace frond {

/// Light on its way through a layer of leaves is exp(-kExtinction * m2 of leaves over a m2).
inline constexpr double kExtinction = 0.5;

/// The leaves and the light of a year, in layers over the ground.
struct Canopy {
  static constexpr double kLayer = 2;  ///< metres

  StandGrid grid;
  int layers = 1;
  /// Share of light, 0..1, at the foot of each layer and above the last; layer by layer, cell by cell.
  std::vector<float> light{};
  std::vector<float> top{};  ///< metres, of each cell: its highest crown

  double ground_light(std::size_t cell) const { return static_cast<double>(light[cell]); }
  /// Share of light, 0..1, in a cell at a height in metres, or up to a layer above it.
  double light_above(std::size_t cell, double height) const {
    int layer = std::clamp(static_cast<int>(height / kLayer) + 1, 0, layers);
    return static_cast<double>(light[static_cast<std::size_t>(layer) * grid.size() + cell]);
  }
};

/// The canopy of these trees; the same with any number of threads.
Canopy canopy_of(std::span<const StandTree> trees, std::span<const TreeSpecies> species,
                 const StandGrid& grid);

/// Light of 0..1 on a crown, its own shade left out.
struct CrownLight {
  double top = 1;   ///< on its top
  double mean = 1;  ///< on all of it: its top and its sides at two heights
};
CrownLight light_on(const Canopy& canopy, const StandTree& tree, const TreeSpecies& species);

}  // namespace frond
