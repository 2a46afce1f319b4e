#pragma once

#include "dynamics/canopy.h"

namespace frond {

/// How a tree dies, or none.
struct TreeDeath {
  DeathCause cause = DeathCause::none;
  double azimuth = 0;  ///< radians, the direction of its fall
  double broken = 0;   ///< metres, the height of what is left standing; 0: it falls with its roots
};

/// Trees that grow too little die the likelier the less they bear shade, as in gap models; of age the chance
/// rises so that exp(-1) are left at their lifespan (Weibull, with shape 4).
TreeDeath quiet_death(const StandTree& tree, const TreeSpecies& species, double year, Seed seed);

/// The strongest gust of a year.
struct YearGust {
  double speed = 0;   ///< m/s, in the open
  double toward = 0;  ///< azimuth to which it blows
};

/// Load of a gust on a tree over what its roots hold. The crown's drag is 0.35 up to 25 m/s and bends out of
/// the wind beyond (Rudnicki et al. 2004); bare crowns have 0.6 of it. Roots hold in proportion to the
/// fresh stem (Nicoll et al. 2006), more where the tree is stout. `exposure` is 1 in the open.
double wind_load(const StandTree& tree, const TreeSpecies& species, double speed, double exposure);

/// 1 in the open .. 0.2 in a closed stand, by how high the canopy is 5 to 40 m against the wind.
double exposure_of(const Canopy& canopy, const StandTree& tree, double toward);

/// Trees that a gust throws or breaks, and those that these strike as they fall. Those that have died already
/// stay as they are.
void add_storm_deaths(std::vector<TreeDeath>& deaths, std::span<const StandTree> trees,
                      std::span<const TreeSpecies> species, const Canopy& canopy, const YearGust& gust,
                      Seed seed);

/// Slender evergreens that snow breaks; `load` is 1 in a mean winter (Päätalo et al. 1999: from 80 of
/// height over diameter on).
TreeDeath snow_death(const StandTree& tree, const TreeSpecies& species, double load, Seed seed);

}  // namespace frond
