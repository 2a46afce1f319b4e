#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/seed.h"
#include "core/vec.h"

// Stand dynamics: the trees of a piece of land over centuries
// ===========================================================
// Each tree is an individual with a place; a step is a year. Trees compete for light, which is a field over
// the whole land, grow in height and in girth as the light allows, seed themselves, and die of shade, age,
// storms and snow; what has died stands or lies until it has rotted. Models of this family: JABOWA (Botkin
// 1972), SORTIE (Pacala 1996), iLand (Seidl 2012).
//
//     StandOptions options;
//     options.species = {species(TreeName::birch), species(TreeName::beech)};
//     StandHistory history = simulate_stand(options, level_land(), Seed{1});
//     for (std::uint32_t i : living_at(history, 120.5)) draw(history.lives[i], size_at(history, i, 120.5));
//
// The sources of the species' numbers stand at the table in species.cpp.
//
// Metres and years; x and z from the middle of the land; azimuths in radians from +z toward +x.

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

/// What happens to the stand in a year.
struct StandEvent {
  int year = 1;
  double storm = 0;                     ///< strength, 0 none .. 1 gusts of kWorstStorm, see core/events.h
  std::optional<TreeName> cut = {};     ///< trees of which some are felled and carried away
  double share = 0.5;                   ///< share of these trees that are felled, drawn by lot
  std::optional<TreeName> pruned = {};  ///< trees that lose their lower limbs
  double below = 0;                     ///< metres above the foot up to which these trees lose limbs
};

/// Share of the height of a tree up to which pruning takes limbs at most.
inline constexpr double kMostPruned = 0.6;

/// Trees that stand on the land at year 0, at random places.
struct StandPlanting {
  TreeName name = TreeName::beech;
  double density = 2000;  ///< a hectare
};

struct StandOptions {
  Vec2 area{200, 200};  ///< metres along x and z
  int years = 200;
  double cell = 2;  ///< metres, the side of a cell of the fields of light and of seedlings
  std::vector<TreeSpecies> species;
  std::vector<StandPlanting> planted;
  bool seeding = true;      ///< whether trees come up by themselves
  double storms = 1;        ///< factor of natural storms' and snow's loads; 0 none
  double temperature = 13;  ///< degrees, the growing season's mean at height 0; 6.5 K less a kilometre higher
  std::vector<StandEvent> events;
};

/// A species of the table as an author changes it; what is not given is as in the table.
struct TreeText {
  TreeName name = TreeName::beech;
  std::string organism;  ///< "name" of the organism that is drawn; empty: none
  std::optional<double> height, girth_gain, tolerance, lifespan, anchorage, reach, seeds, arrival, coldest,
      moisture;
};

/// A stand as its author writes it; what StandOptions has, and the moisture of the ground.
struct StandText {
  Vec2 area{200, 200};
  int years = 200;
  std::optional<Vec2> shown;      ///< years that a film shows, first and last; none: all
  std::vector<TreeText> species;  ///< none: all of the table
  std::vector<StandPlanting> planted;
  bool seeding = true;
  double storms = 1, temperature = 13, moisture = 0.5;
};
/// Without events, which are not the stand's own.
StandOptions options_of(const StandText& text);

/// Faults of a stand, each at a pointer below it: species named twice, planted ones that it does not have,
/// years shown that are not simulated.
Errors stand_faults(const StandText& text);

/// The ground at a place.
struct StandGround {
  double height = 0;      ///< metres
  double moisture = 0.5;  ///< 0 dry .. 1 wet
};
using StandLand = std::function<StandGround(double x, double z)>;

enum class DeathCause { none, suppressed, age, storm, snow, struck, cut };

/// How large a tree is in a year.
struct TreeSize {
  float year = 0;
  float height = 0;        ///< metres
  float diameter = 0;      ///< metres, at breast height
  float crown_radius = 0;  ///< metres
  float crown_base = 0;    ///< metres, height of the lowest living branches
};

/// The life of a tree, and what becomes of its wood.
struct TreeLife {
  static constexpr float kNever = std::numeric_limits<float>::infinity();

  std::uint32_t species = 0;  ///< index in StandHistory::species
  float x = 0, z = 0;
  float born = 0;       ///< year in which it came up; may be before 0
  float died = kNever;  ///< from then on it has no leaves
  float fell = kNever;  ///< from then on it lies; a snag stands before. It was carried away where it was cut
  float rotted = kNever;  ///< from then on there is nothing left
  float azimuth = 0;      ///< direction in which it falls
  float broken = 0;       ///< metres above the ground, where its stem breaks; 0: it falls with its roots
  DeathCause cause = DeathCause::none;
  std::uint32_t first = 0, count = 0;  ///< its course in StandHistory::sizes
};

/// All that happened. Trees that die as seedlings, below breast height, are not in it.
struct StandHistory {
  Vec2 area{0};
  int years = 0;
  std::vector<TreeSpecies> species;
  std::vector<TreeLife> lives;  ///< by the year in which they reached breast height
  /// The sizes of each life at its birth, at breast height, in each fifth year and at its end, one life after
  /// another (TreeLife::first, `count`).
  std::vector<TreeSize> sizes{};
};

/// A dead tree in a year.
struct Deadwood {
  std::uint32_t life = 0;
  bool lies = false;
  float decay = 0;  ///< 0 as it died .. 1 rotted
};

/// Level land of middling moisture.
StandLand level_land();

/// Simulates all years. The same bytes at any number of threads.
StandHistory simulate_stand(const StandOptions& options, const StandLand& land, Seed seed);

/// The size of a tree, continuous over the years of its life; nothing before it, and as it died after it.
TreeSize size_at(const StandHistory& history, std::uint32_t life, double year);

/// Lives that are lived in a year, seedlings of later trees among them, and those whose wood is still there,
/// in the order of `lives`.
std::vector<std::uint32_t> living_at(const StandHistory& history, double year);
std::vector<Deadwood> deadwood_at(const StandHistory& history, double year);

/// Dry mass of a stem, kg. It holds 0.45 of the cylinder of its diameter and height.
double stem_mass(const TreeSpecies& species, const TreeSize& size);

}  // namespace frond
