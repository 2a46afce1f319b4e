#pragma once

#include <string>

#include "dynamics/figures.h"

namespace frond {

/// Plots of a stand as SVG: basal area of each species over the years; density over the mean mass of a tree,
/// with the line of self-thinning; diameters, ages and gaps of a year, and its map, -z at the top: crowns
/// of trees above 3 m, and fallen stems thicker than 20 cm.
std::string stand_svg(const StandHistory& history, double year);

/// Figures of each fifth year as comma-separated values, with a line of names.
std::string stand_csv(const StandHistory& history);

}  // namespace frond
