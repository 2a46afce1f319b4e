#include "dynamics/seedlings.h"

#include <algorithm>

#include "core/parallel.h"

namespace frond {

namespace {

constexpr double kBreastHeight = 1.3;
constexpr double kSaplings = 0.6;     // of less than 4 m that find room on a m2
constexpr double kMostSeedlings = 3;  // on a m2
constexpr int kSeedShares = 8;        // into which the seeds of a tree are cut

int poisson(double mean, Seed seed) {
  double u = seed.unit(), p = std::exp(-mean), sum = p;
  int n = 0;
  for (; u > sum && n < 40; sum += p) p *= mean / ++n;
  return n;
}

/// Leaves of a cohort over the ground, m2 a m2.
double cover(const Cohort& c) {
  return std::min(0.3 * static_cast<double>(c.count * c.height * c.height), 2.0);
}

/// Share of the seeds of a species that come up.
double coming_up(const TreeSpecies& species, const SeedBed& bed, std::size_t cell) {
  auto bare = static_cast<double>(bed.bare[cell]), wood = static_cast<double>(bed.wood[cell]);
  return bare + wood * species.wood + std::max(1 - bare - wood, 0.0) * species.litter;
}

/// A year of a cohort in a light; its height may pass breast height.
void grow_cohort(Cohort& c, const TreeSpecies& species, double light, double site, double arrives,
                 double year) {
  double response = light_response(species, light) * site;
  double lasts = 0.02 + 0.02 * (5 - species.tolerance);  // growth that seedlings live by
  c.count *= static_cast<float>(0.95 - 0.65 * std::exp(-response / lasts));
  if (c.count < 1e-4f) c = {0, 0.05f, static_cast<float>(year)};
  c.count = static_cast<float>(
      std::min(static_cast<double>(c.count) + arrives * std::min(site * 2, 1.0), kMostSeedlings));
  auto height = static_cast<double>(c.height);
  double rise = height_at(species, age_at(species, height) + 1) - height;
  c.height = static_cast<float>(height + rise * std::min(1.5 * response, 1.0));
}

/// One row of cells.
struct SeedlingRow {
  Seedlings& seedlings;
  std::span<const TreeSpecies> species;
  const SeedlingPlace& place;
  std::span<const std::uint8_t> saplings;
  double year;

  Cohort& cohort(std::size_t s, std::size_t cell) const {
    return seedlings.cohorts[s * seedlings.grid.size() + cell];
  }

  void grow_cell(std::size_t cell) const {
    std::size_t cells = seedlings.grid.size();
    std::vector<double> light(species.size(), place.canopy.ground_light(cell));
    for (std::size_t s = 0; s < species.size(); ++s)
      for (std::size_t other = 0; other < species.size(); ++other)
        if (cohort(other, cell).height > cohort(s, cell).height)
          light[s] *= std::exp(-kExtinction * cover(cohort(other, cell)));
    for (std::size_t s = 0; s < species.size(); ++s) {
      double arrives =
          static_cast<double>(seedlings.arrived[s * cells + cell]) * coming_up(species[s], place.bed, cell);
      grow_cohort(cohort(s, cell), species[s], light[s], static_cast<double>(place.site[s * cells + cell]),
                  arrives, year);
    }
  }

  /// Where a seedling stands: somewhere in its cell, or on the log there.
  glm::dvec2 spot(std::size_t s, std::size_t cell, int column, int row, Seed seed) const {
    const StandGrid& grid = seedlings.grid;
    glm::dvec2 at(grid.low_x + (column + seed.child(0).unit()) * grid.cell,
                  grid.low_z + (row + seed.child(1).unit()) * grid.cell);
    std::uint32_t lies = place.bed.log[cell];
    double on_wood = static_cast<double>(place.bed.wood[cell]) * species[s].wood;
    if (lies == SeedBed::kNone || seed.child(2).unit() * coming_up(species[s], place.bed, cell) >= on_wood)
      return at;
    const StandLog& log = place.logs[lies];
    glm::dvec2 foot = log.point(0), along = log.point(1) - foot;
    return log.point(std::clamp(glm::dot(at - foot, along) / glm::dot(along, along), 0.0, 1.0));
  }

  void recruit(int column, int row, std::vector<Recruit>& out, Seed seed) const {
    const StandGrid& grid = seedlings.grid;
    std::size_t cell = grid.index(column, row);
    int room = std::max(static_cast<int>(kSaplings * grid.cell * grid.cell), 1) - saplings[cell];
    // Where there is too little room for all, another species comes first in each cell.
    std::size_t begin = seed.bits() % species.size();
    for (std::size_t i = 0; i < species.size(); ++i) {
      std::size_t s = (begin + i) % species.size();
      Cohort& c = cohort(s, cell);
      if (static_cast<double>(c.height) < kBreastHeight) continue;
      Seed own = seed.child(s);
      int count = std::min(poisson(static_cast<double>(c.count) * grid.cell * grid.cell, own), room);
      for (int n = 0; n < count; ++n) {
        glm::dvec2 at = spot(s, cell, column, row, own.child(static_cast<std::uint64_t>(n)));
        if (grid.inside(at.x, at.y))
          out.push_back({static_cast<std::uint32_t>(s), at.x, at.y, static_cast<double>(c.since)});
      }
      room -= std::max(count, 0);
      c = {};
    }
  }
};

}  // namespace

SeedBed seed_bed(const StandGrid& grid, std::span<const StandLog> logs, double year) {
  SeedBed bed;
  bed.bare.assign(grid.size(), static_cast<float>(0.5 * std::exp(-year / 8)));
  bed.wood.assign(grid.size(), 0);
  bed.log.assign(grid.size(), SeedBed::kNone);
  for (std::uint32_t i = 0; i < logs.size(); ++i) {
    const StandLog& log = logs[i];
    if (log.uprooted && log.diameter > 0.2 && year < log.fell + 10) bed.bare[grid.at(log.x, log.z)] = 0.8f;
    if (log.diameter < 0.15 || year < log.fell + 0.25 * (log.rotted - log.fell)) continue;
    double step = 0.5 * grid.cell;
    for (double along = 0; along < 0.8 * log.length; along += step) {
      glm::dvec2 at = log.point(along / log.length);
      if (!grid.inside(at.x, at.y)) continue;
      std::size_t cell = grid.at(at.x, at.y);
      bed.wood[cell] = std::min(
          bed.wood[cell] + static_cast<float>(0.7 * log.diameter * step / (grid.cell * grid.cell)), 0.5f);
      bed.log[cell] = i;
    }
  }
  return bed;
}

void sow_year(Seedlings& seedlings, std::span<const StandTree> trees, std::span<const TreeSpecies> species,
              Seed seed) {
  const StandGrid& grid = seedlings.grid;
  parallel_for(species.size(), [&](std::size_t s) {
    const TreeSpecies& kind = species[s];
    Seed own = seed.child(s);
    double mast = std::exp(0.7 * own.normal() - 0.245);  // mean 1
    std::span<float> arrived = std::span(seedlings.arrived).subspan(s * grid.size(), grid.size());
    std::ranges::fill(arrived, static_cast<float>(kind.arrival * mast));
    for (const StandTree& tree : trees) {
      if (tree.species != s || tree.height < 0.3 * kind.height ||
          age_at(kind, tree.height) < 0.5 * kind.first_seeds)
        continue;
      double crown = kPi * tree.crown_radius * tree.crown_radius * std::min(1.5 * tree.vigour, 1.0);
      auto share = static_cast<float>(kind.seeds * mast * crown / (kSeedShares * grid.cell * grid.cell));
      for (std::uint64_t n = 0; n < kSeedShares; ++n) {
        Seed flight = own.child(tree.life).child(n);
        double away = seed_distance(kind, flight.child(0).unit()), toward = 2 * kPi * flight.child(1).unit();
        double x = tree.x + away * std::sin(toward), z = tree.z + away * std::cos(toward);
        if (grid.inside(x, z)) arrived[grid.at(x, z)] += share;
      }
    }
  });
}

std::vector<Recruit> grow_seedlings(Seedlings& seedlings, std::span<const TreeSpecies> species,
                                    const SeedlingPlace& place, double year, Seed seed) {
  const StandGrid& grid = seedlings.grid;
  std::vector<std::uint8_t> saplings(grid.size());
  for (const StandTree& tree : place.trees) {
    std::uint8_t& count = saplings[grid.at(tree.x, tree.z)];
    if (tree.height < 4 && count < 255) ++count;
  }
  std::vector<std::vector<Recruit>> found(static_cast<std::size_t>(grid.rows));
  SeedlingRow cells{seedlings, species, place, saplings, year};
  parallel_for(found.size(), [&](std::size_t r) {
    int row = static_cast<int>(r);
    for (int column = 0; column < grid.columns; ++column) {
      std::size_t cell = grid.index(column, row);
      cells.grow_cell(cell);
      cells.recruit(column, row, found[r], seed.child(cell));
    }
  });
  return joined(found);
}

}  // namespace frond
