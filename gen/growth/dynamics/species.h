#pragma once

#include <span>
#include <string_view>

// The trees of a stand, as numbers. Their sources stand at the table in species.cpp.

namespace frond {

enum class TreeName { birch, aspen, rowan, oak, pine, beech, spruce, fir };

/// By what seeds travel.
enum class SeedCarrier { wind, gravity, animals };

/// A kind of tree: how it grows, bears shade, seeds itself and dies.
struct TreeSpecies {
  TreeName name = TreeName::birch;

  // Height at age t: height * (1 - exp(-rate t))^shape (Chapman and Richards).
  double height = 30;  ///< metres, the greatest
  double rate = 0.03;  ///< 1/year
  double shape = 1.2;  ///< above 1: slow at first

  double girth_gain = 2.5;  ///< cm a year, of a tree in the open
  double diameter = 0.8;    ///< metres at breast height, the greatest
  double crown_foot = 0.6;  ///< metres, radius of the crown of the thinnest tree
  double crown_gain = 8;    ///< metres of that radius for each metre of diameter
  double leaf_area = 3;     ///< m2 of leaves over each m2 of its crown

  double tolerance = 2.5;  ///< of shade: 1 needs full light .. 5 grows in deep shade
  double lifespan = 150;   ///< years, by which two in three would be dead of age alone
  double density = 500;    ///< kg of dry wood in a m3 of fresh wood
  double anchorage = 150;  ///< N m that roots hold for each kg of fresh stem
  bool evergreen = false;
  double decay = 0.05;  ///< 1/year, of wood that lies

  SeedCarrier carrier = SeedCarrier::wind;
  double reach = 50;        ///< metres, the median distance of seeds from their tree
  double first_seeds = 20;  ///< years of age
  double seeds = 1;         ///< seedlings a year for each m2 of its crown, where all suits them
  double arrival = 0.01;    ///< the same from beyond the land, on each m2 of it
  double litter = 0.5;      ///< share of them that comes up in leaf litter; on bare soil all do
  double wood = 0.5;        ///< share that comes up on rotting logs

  double coldest = 7;          ///< degrees, mean of the growing season below which it does not grow
  double moisture = 0.5;       ///< 0 dry .. 1 wet, which it likes best
  double moisture_span = 0.4;  ///< how far from there it grows at 0.6 of its best
};

/// All of them, in the order of TreeName.
std::span<const TreeSpecies> tree_species();

inline const TreeSpecies& species(TreeName name) { return tree_species()[static_cast<std::size_t>(name)]; }

std::string_view name_of(TreeName name);

/// Height in the open at an age, and the age of that height; heights from the greatest on have 1000 years.
double height_at(const TreeSpecies& species, double age);
double age_at(const TreeSpecies& species, double height);

/// Metres from the tree within which a share `q` in 0..1 of its seeds lies. Seeds on the wind follow the
/// kernel 2Dt with a tail (p = 1; Clark et al. 1999), those that fall a normal distribution, and those that
/// animals carry an exponential one.
double seed_distance(const TreeSpecies& species, double q);

}  // namespace frond
