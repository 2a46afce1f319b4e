#pragma once

#include <string>

#include "dynamics/reef.h"

// What surveys of reefs measure.

namespace frond {

/// Plots of a reef as SVG: cover of each species, and of algae and rubble, over the years with their storms
/// and heat waves; colonies and rugosity; the sizes of a year, its map, -z at the top, and its shares.
std::string reef_svg(const ReefHistory& history, double year);

/// Figures of each year as comma-separated values, with a line of names: cover of each species and of all
/// colonies, of macroalgae, coralline algae, rubble and turf, in percent of the floor as seen from above;
/// living colonies of 5 cm and more on a m2; rugosity.
std::string reef_csv(const ReefHistory& history);

}  // namespace frond
