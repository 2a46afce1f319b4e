#pragma once

#include <string>
#include <vector>

#include "dynamics/stand.h"

// What foresters measure of a stand.

namespace frond {

/// Figures of a year; trees count from breast height on.
struct StandFigures {
  double density = 0;              ///< trees a hectare
  double mean_mass = 0;            ///< kg, of a living tree
  std::vector<double> basal_area;  ///< of each species, m2 of stems a hectare
  std::vector<int> diameters;      ///< trees in classes of 5 cm
  std::vector<int> ages;           ///< trees in classes of 10 years
  std::vector<double> gaps;        ///< m2 of each, largest first
};

StandFigures figures_at(const StandHistory& history, double year);

/// Areas that no crown covers which is higher than half of the highest trees (their 95th percentile), in
/// m2, joined over the sides of cells of 2 m; single cells are left out.
std::vector<double> gaps_at(const StandHistory& history, double year);

/// Plots of a stand as SVG: basal area of each species over the years; density over the mean mass of a tree,
/// with the line of self-thinning; diameters, ages and gaps of a year, and its map, -z at the top: crowns
/// of trees above 3 m, and fallen stems thicker than 20 cm.
std::string stand_svg(const StandHistory& history, double year);

/// Figures of each fifth year as comma-separated values, with a line of names.
std::string stand_csv(const StandHistory& history);

}  // namespace frond
