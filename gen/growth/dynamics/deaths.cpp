#include "dynamics/deaths.h"

#include <algorithm>

namespace frond {

namespace {

constexpr double kAir = 1.2;  // kg/m3

/// Trees in the way of a fall: the larger one breaks those that are much thinner than it.
void strike(std::vector<TreeDeath>& deaths, std::span<const StandTree> trees, const TreeRows& rows,
            const StandGrid& grid, std::size_t falling, Seed seed) {
  const StandTree& tree = trees[falling];
  double azimuth = deaths[falling].azimuth, above = deaths[falling].broken, length = tree.height - above;
  double dx = std::sin(azimuth), dz = std::cos(azimuth);
  double end = tree.z + length * dz;
  int from = grid.row(std::min(tree.z, end)) - 1, to = grid.row(std::max(tree.z, end)) + 1;
  for (std::uint32_t i : rows.in(from, to)) {
    const StandTree& other = trees[i];
    double x = other.x - tree.x, z = other.z - tree.z;
    double along = x * dx + z * dz, aside = std::abs(x * dz - z * dx);
    if (i == falling || deaths[i].cause != DeathCause::none || along < 0.5 || along > length) continue;
    if (aside > 0.4 + 0.4 * tree.crown_radius) continue;
    double thin = 1 - other.diameter / (0.7 * tree.diameter);
    Seed own = seed.child(other.life);
    if (own.child(0).unit() < thin)
      deaths[i] = {DeathCause::struck, azimuth + own.child(1).range(-0.6, 0.6),
                   std::min(own.child(2).range(0.1, 0.5) * other.height, 3.0)};
  }
}

}  // namespace

TreeDeath quiet_death(const StandTree& tree, const TreeSpecies& species, double year, Seed seed) {
  double scale = 0.085 + 0.02 * (5 - species.tolerance);
  double suppressed = 0.3 * std::exp(-tree.vigour / scale);
  double age = (year - tree.born) / species.lifespan;
  double old = 4 * age * age * age / species.lifespan;
  double chance = seed.child(0).unit(), azimuth = 2 * kPi * seed.child(1).unit();
  if (chance < old) return {DeathCause::age, azimuth, 0};
  return {chance < old + suppressed + 0.001 ? DeathCause::suppressed : DeathCause::none, azimuth, 0};
}

double wind_load(const StandTree& tree, const TreeSpecies& species, double speed, double exposure) {
  speed *= std::min(tree.height / 20, 1.0);  // weak near the ground
  double drag = 0.35 * std::min(25 / std::max(speed, 1.0), 1.0) * (species.evergreen ? 1 : 0.6);
  double area = 4.0 / 3 * tree.crown_radius * tree.crown_length();
  double arm = tree.crown_base + 0.4 * tree.crown_length();
  // A quarter is added by the weight of the tree that leans.
  double moment = 1.25 * 0.5 * kAir * drag * area * speed * speed * arm * exposure;
  double stout = std::clamp(80 * tree.diameter / tree.height, 0.8, 1.6);
  return moment / (species.anchorage * fresh_mass(species, tree) * stout);
}

double exposure_of(const Canopy& canopy, const StandTree& tree, double toward) {
  double shelter = 0;
  for (int i = 1; i <= 8; ++i) {
    std::size_t cell = canopy.grid.at(tree.x - 5 * i * std::sin(toward), tree.z - 5 * i * std::cos(toward));
    shelter += std::min(static_cast<double>(canopy.top[cell]) / tree.height, 1.0) / 8;
  }
  return 1 - 0.8 * shelter;
}

void add_storm_deaths(std::vector<TreeDeath>& deaths, std::span<const StandTree> trees,
                      std::span<const TreeSpecies> species, const Canopy& canopy, const YearGust& gust,
                      Seed seed) {
  std::vector<std::size_t> thrown;
  for (std::size_t i = 0; i < trees.size(); ++i) {
    const StandTree& tree = trees[i];
    if (deaths[i].cause != DeathCause::none || tree.height < 5) continue;
    Seed own = seed.child(tree.life);
    double load = wind_load(tree, species[tree.species], gust.speed, exposure_of(canopy, tree, gust.toward));
    // Soils and roots differ: half of the trees fall at a load of 1, one in a thousand at half of that.
    if (own.child(0).unit() >= 1 / (1 + std::pow(load, -10))) continue;
    bool breaks = own.child(1).unit() < 0.25;
    deaths[i] = {DeathCause::storm, gust.toward + 0.2 * own.child(2).normal(),
                 breaks ? own.child(3).range(0.1, 0.4) * tree.height : 0};
    thrown.push_back(i);
  }
  TreeRows rows(trees, canopy.grid);
  for (std::size_t i : thrown)
    strike(deaths, trees, rows, canopy.grid, i, seed.child("strike", trees[i].life));
}

TreeDeath snow_death(const StandTree& tree, const TreeSpecies& species, double load, Seed seed) {
  double slender = std::max(tree.height / tree.diameter / 80 - 1, 0.0);
  double chance = 0.006 * load * load * slender * slender * (species.evergreen ? 1 : 0.1);
  if (tree.height < 3 || seed.child(0).unit() >= std::min(chance, 0.5)) return {};
  return {DeathCause::snow, 2 * kPi * seed.child(1).unit(), seed.child(2).range(0.2, 0.6) * tree.height};
}

}  // namespace frond
