#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

// What kinds of colonies live on a reef, by the growth forms that surveys tell apart, and the rates at which
// they settle, grow, compete and die. The rates are one table with a range and a source for each.

namespace frond {

enum class ColonyName { tabular, branching, bushy, massive, brain, encrusting, foliose, soft, sponge };
inline constexpr std::size_t kColonyNames = 9;

/// The rates of a species. Lengths of the table are metres, but for growth, which is cm a year.
struct ColonySpecies {
  ColonyName name = ColonyName::tabular;

  double extension = 5;      ///< cm a year, of its rim, in the light and unhindered
  double rise = 3;           ///< cm a year, upward
  double widest = 2;         ///< diameter of the largest
  double tallest = 0.5;      ///< height of the largest
  double slenderness = 0.5;  ///< height over diameter at most
  double foot = 1;           ///< diameter of its foot over its own; below 1 it spreads above the ground
  double crown = 1;          ///< share of its height that what spreads above the foot takes

  double rank = 5;         ///< in competition: it overgrows colonies of lower ranks
  double shade = 0.5;      ///< share of the light that it takes from what is below it
  double tolerance = 0.5;  ///< of shade, 0 needs full light .. 1 grows without

  double arrival = 0.5;  ///< recruits a year old on each m2 of free hard ground a year, from other reefs
  double larvae = 1;     ///< the same from here, where the species covers all of the floor

  double young_death = 0.4;  ///< share of those narrower than 5 cm that die in a year
  double death = 0.05;       ///< share of the full-grown that die in a year, without storms and heat
  double injury = 0.05;      ///< share of its area that a colony loses in a year
  double shape_factor = 1;   ///< colony shape factor at a diameter of 1 m
  double top_heavy = 0;      ///< exponent by which that rises with the diameter
  double lethal_heat = 8;    ///< degree heating weeks of which half of them die
  double reattach = 0;       ///< share of the dislodged of which a fragment lives on
  double skeleton = 5;       ///< years for which a dead one stands
  double rubble = 0;         ///< share of its area that its fragments cover with rubble
};

/// A rate of the table as authors may change it.
struct ColonyRate {
  std::string_view name;
  double ColonySpecies::*at;
  double min, max;
  std::string_view unit;  ///< empty: none
  std::string_view doc;
};
inline constexpr std::size_t kColonyRates = 21;
std::span<const ColonyRate, kColonyRates> colony_rates();

/// Values for some of the rates, in the order of colony_rates().
using ChangedRates = std::array<std::optional<double>, kColonyRates>;

/// All of them, in the order of ColonyName.
std::span<const ColonySpecies> colony_species();

inline const ColonySpecies& species(ColonyName name) {
  return colony_species()[static_cast<std::size_t>(name)];
}

std::string_view name_of(ColonyName name);

/// The colony shape factor of Madin and Connolly 2006 at a diameter in metres: the drag's moment on a colony
/// against the section of its attachment.
double shape_factor_at(const ColonySpecies& species, double diameter);

/// Share of colonies that a heat wave of so many degree heating weeks kills, 0..1.
double heat_death(const ColonySpecies& species, double weeks);

}  // namespace frond
