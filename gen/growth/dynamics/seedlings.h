#pragma once

#include <vector>

#include "dynamics/trees.h"

// What is below breast height: in each cell one cohort of each species, whose tallest seedlings count.

namespace frond {

/// A tree that lies on the ground.
struct StandLog {
  std::uint32_t life = 0;
  double x = 0, z = 0, azimuth = 0, length = 0, diameter = 0;
  double fell = 0, rotted = 0;
  bool uprooted = false;

  /// The point at a share of its length.
  glm::dvec2 point(double share) const {
    return {x + share * length * std::sin(azimuth), z + share * length * std::cos(azimuth)};
  }
};

/// What seeds find on the ground of each cell.
struct SeedBed {
  static constexpr std::uint32_t kNone = ~0u;
  std::vector<float> bare, wood;   ///< shares of the cell; the rest has litter
  std::vector<std::uint32_t> log;  ///< a log that lies there
};

/// Half of a clearing is bare at first, as long as it is young; later soil is bare where roots were torn
/// out, for ten years. Seedlings come up on logs once these have begun to rot.
SeedBed seed_bed(const StandGrid& grid, std::span<const StandLog> logs, double year);

/// Seedlings of a species in a cell.
struct Cohort {
  float count = 0;   ///< expected, on a m2
  float height = 0;  ///< metres
  float since = 0;   ///< year in which it came up
};

struct Seedlings {
  StandGrid grid;
  std::vector<Cohort> cohorts;  ///< species by species, cell by cell
  std::vector<float> arrived;   ///< seeds of the year that would come up on bare soil, on a m2; likewise

  Seedlings(const StandGrid& g, std::size_t species)
      : grid(g), cohorts(g.size() * species), arrived(g.size() * species) {}
};

/// The seeds of a year: those of all trees, and those that come from beyond the land. Their number varies
/// from year to year (masting).
void sow_year(Seedlings& seedlings, std::span<const StandTree> trees, std::span<const TreeSpecies> species,
              Seed seed);

/// A seedling that has come to breast height.
struct Recruit {
  std::uint32_t species = 0;
  double x = 0, z = 0, born = 0;
};

/// What seedlings grow in.
struct SeedlingPlace {
  const Canopy& canopy;
  const SeedBed& bed;
  std::span<const StandLog> logs;
  std::span<const StandTree> trees;
  std::span<const float> site;  ///< site_response(), species by species, cell by cell
};

/// Seedlings come up, grow, shade each other and die; those that come to breast height leave their cohort,
/// as many as a cell has room for.
std::vector<Recruit> grow_seedlings(Seedlings& seedlings, std::span<const TreeSpecies> species,
                                    const SeedlingPlace& place, double year, Seed seed);

}  // namespace frond
