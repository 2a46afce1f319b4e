#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/seed.h"
#include "core/vec.h"
#include "dynamics/colonies.h"

// Reef dynamics: the colonies of a piece of sea floor over a century
// ===================================================================
// What stand.h is for trees. Each colony is an individual with a place, a radius and a height; a step is a
// year. Colonies settle on free ground, grow at their rims and upward, shade and overgrow each other, are
// injured, and die of age, shade, algae, heat and storms. Between them algae grow and are grazed, and what
// breaks becomes rubble, on which nothing settles until it is bound. Models of this family: Tam and Ang 2012,
// Madin et al. 2014, Cresswell et al. 2020; of the algae Mumby et al. 2007.
//
//     ReefOptions options;
//     options.species = {species(ColonyName::tabular), species(ColonyName::massive)};
//     ReefHistory history = simulate_reef(options, Seed{1});
//     for (std::uint32_t i : living_at(history, 30.5)) draw(history.lives[i], size_at(history, i, 30.5));
//
// Metres and years; x and z from the middle of the floor; azimuths in radians from +z toward +x.

namespace frond {

/// What happens to the reef in a year.
struct ReefEvent {
  int year = 1;
  double storm = 0;  ///< strength, 0 none .. 1 water of kWorstWaves
  double heat = 0;   ///< degree heating weeks of a heat wave
};

/// Colonies that are planted at year 0, at random places.
struct Outplant {
  ColonyName name = ColonyName::branching;
  double density = 1;     ///< on a m2
  double diameter = 0.1;  ///< metres
};

struct ReefOptions {
  Vec2 area{10, 10};  ///< metres along x and z
  int years = 100;
  std::vector<ColonySpecies> species;
  std::vector<Outplant> planted;
  bool settling = true;   ///< whether larvae settle
  double storms = 1;      ///< factor of the drag of the waves of each year; 0 none
  double grazing = 0.6;   ///< 1/year: rate at which fishes and urchins graze the floor, as g of Mumby 2007
  double algae = 0.8;     ///< 1/year: rate at which macroalgae spread over turf, as gamma there
  double binding = 0.15;  ///< 1/year: rate at which rubble is bound
  std::vector<ReefEvent> events;
};

/// Water speeds at the floor, m/s: the strongest of an ordinary year, and in the worst storm.
inline constexpr double kOrdinaryWaves = 1.2, kWorstWaves = 6;

enum class ColonyDeath { none, background, shaded, overgrown, algae, heat, storm };

/// How large a colony is in a year.
struct ColonySize {
  float year = 0;
  float radius = 0, height = 0;  ///< metres
};

/// The life of a colony, and what becomes of its skeleton.
struct ColonyLife {
  static constexpr float kNever = std::numeric_limits<float>::infinity();

  std::uint32_t species = 0;  ///< index in ReefHistory::species
  float x = 0, z = 0;
  float born = 0;  ///< year in which it settled or was planted
  float died = kNever;
  float gone = kNever;  ///< from then on there is nothing left
  float azimuth = 0;    ///< direction in which it rolls
  float rolled = 0;     ///< metres that a storm has rolled it; 0: it stands where it grew
  ColonyDeath cause = ColonyDeath::none;
  std::uint32_t first = 0, count = 0;  ///< its course in ReefHistory::sizes
};

/// The reef at the end of a year. All shares are of the floor as seen from above; they add up to 1.
struct ReefYear {
  std::vector<double> cover;  ///< of each species
  double macroalgae = 0, coralline = 0, rubble = 0, turf = 0;
  double colonies = 0;  ///< living ones on a m2, from a diameter of 5 cm on
  double rugosity = 1;  ///< length of a line over the surface against a straight one

  double colony_cover() const;  ///< of all species
};

/// All that happened.
struct ReefHistory {
  Vec2 area{0};
  int years = 0;
  std::vector<ColonySpecies> species;
  std::vector<ReefEvent> events;
  std::vector<ColonyLife> lives;    ///< by the year in which they settled
  std::vector<ColonySize> sizes{};  ///< of each life at its birth, after each year and at its end
  std::vector<ReefYear> course{};   ///< of the years 0 to `years`
};

/// A species of the table as an author changes it; what is not given is as in the table.
struct ColonyText {
  ColonyName name = ColonyName::tabular;
  std::string organism;  ///< "name" of the organism that is drawn; empty: none
  ChangedRates rates{};
};

/// A reef as its author writes it; what ReefOptions has.
struct ReefText {
  Vec2 area{10, 10};
  int years = 100;
  std::optional<Vec2> shown;        ///< years that a film shows, first and last; none: all
  std::vector<ColonyText> species;  ///< none: all of the table
  std::vector<Outplant> planted;
  bool settling = true;
  double storms = 1, grazing = 0.6, algae = 0.8, binding = 0.15;
};
/// Without events, which are not the reef's own.
ReefOptions options_of(const ReefText& text);

/// Faults of a reef, each at a pointer below it: species named twice, planted ones that it does not have,
/// more colonies than there is memory for, years shown that are not simulated.
Errors reef_faults(const ReefText& text);

/// Simulates all years. The same bytes at any number of threads.
ReefHistory simulate_reef(const ReefOptions& options, Seed seed);

/// The size of a colony, continuous over the years of its life; nothing before it, and as it died after it.
ColonySize size_at(const ReefHistory& history, std::uint32_t life, double year);

/// Lives that are lived in a year, in the order of `lives`.
std::vector<std::uint32_t> living_at(const ReefHistory& history, double year);

/// The space that a colony takes: a disc about its middle from a height on, and below it its foot.
struct ColonyShape {
  double radius = 0, top = 0;  ///< metres
  double under = 0;            ///< height of the underside of its crown; 0: it spreads on the ground
  double foot = 0;             ///< radius of its foot
};
ColonyShape shape_of(const ColonySpecies& species, double radius, double height);

/// Whether two stretches of height have more than a point in common.
bool share_heights(double low_a, double high_a, double low_b, double high_b);

/// Metres by which two colonies could come nearer to each other before they touch; negative where they share
/// space. `distance` is that of their middles.
double room_between(const ColonyShape& a, const ColonyShape& b, double distance);

}  // namespace frond
