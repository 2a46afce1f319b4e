#include <algorithm>

#include "core/events.h"
#include "core/parallel.h"
#include "dynamics/deaths.h"
#include "dynamics/growth.h"
#include "dynamics/seedlings.h"
#include "dynamics/stand.h"

namespace frond {

namespace {

/// A size of a life, before those of each life are brought together.
struct NotedSize {
  std::uint32_t life = 0;
  TreeSize size;
};

/// The stand as it goes from year to year.
struct StandNow {
  const StandOptions& options;
  Seed seed;
  StandGrid grid;
  std::span<const TreeSpecies> species;
  std::vector<float> site{};  // response of each species in each cell
  std::vector<StandTree> trees{};
  std::vector<StandLog> logs{};
  Seedlings seedlings;
  std::vector<TreeLife> lives{};
  std::vector<NotedSize> noted{};
  double wind = 0;  // azimuth to which storms blow
};

void note(StandNow& now, const StandTree& tree, double year) {
  auto f = [](double x) { return static_cast<float>(x); };
  now.noted.push_back(
      {tree.life, {f(year), f(tree.height), f(tree.diameter), f(tree.crown_radius), f(tree.crown_base)}});
}

std::vector<float> sites(const StandOptions& options, const StandGrid& grid, const StandLand& land) {
  std::vector<float> site(options.species.size() * grid.size());
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      StandGround ground =
          land(grid.low_x + (column + 0.5) * grid.cell, grid.low_z + (row + 0.5) * grid.cell);
      double temperature = options.temperature - 0.0065 * ground.height;
      for (std::size_t s = 0; s < options.species.size(); ++s)
        site[s * grid.size() + grid.index(column, row)] =
            static_cast<float>(site_response(options.species[s], temperature, ground.moisture));
    }
  return site;
}

/// A tree that has come to breast height.
void add_tree(StandNow& now, const Recruit& recruit, double year) {
  auto life = static_cast<std::uint32_t>(now.lives.size());
  double site =
      static_cast<double>(now.site[recruit.species * now.grid.size() + now.grid.at(recruit.x, recruit.z)]);
  if (site <= 0) return;
  StandTree tree{
      .life = life, .species = recruit.species, .x = recruit.x, .z = recruit.z, .born = recruit.born};
  tree.talent = std::clamp(1 + 0.12 * now.seed.child("talent", life).normal(), 0.7, 1.3);
  tree.site = site;
  tree.crown_radius = crown_radius_at(now.species[tree.species], tree.diameter);
  TreeLife lived;
  lived.species = tree.species;
  lived.x = static_cast<float>(tree.x), lived.z = static_cast<float>(tree.z);
  lived.born = static_cast<float>(tree.born);
  now.lives.push_back(lived);
  now.noted.push_back({life, {.year = lived.born}});
  note(now, tree, year);
  now.trees.push_back(tree);
}

void plant(StandNow& now) {
  double hectares = now.grid.columns * now.grid.rows * now.grid.cell * now.grid.cell / 1e4;
  for (std::size_t p = 0; p < now.options.planted.size(); ++p) {
    const StandPlanting& planting = now.options.planted[p];
    for (std::uint32_t s = 0; s < now.species.size(); ++s) {
      if (now.species[s].name != planting.name) continue;
      auto count = static_cast<std::uint64_t>(planting.density * hectares);
      for (std::uint64_t i = 0; i < count; ++i) {
        Seed own = now.seed.child("planted", p).child(i);
        add_tree(now,
                 {s, now.grid.low_x * own.child(0).range(-1, 1), now.grid.low_z * own.child(1).range(-1, 1),
                  -age_at(now.species[s], 1.3)},
                 0);
      }
    }
  }
}

/// What is left of a tree: a snag for some years, a log until it has rotted.
void bury(StandNow& now, const StandTree& tree, const TreeDeath& death, double died, Seed seed) {
  const TreeSpecies& species = now.species[tree.species];
  TreeLife& life = now.lives[tree.life];
  bool falls_at_once = death.cause == DeathCause::storm || death.cause == DeathCause::struck ||
                       death.cause == DeathCause::snow;
  // Thin snags stand for a few years, thick ones for decades.
  double snag = falls_at_once ? 0 : (2 + 30 * tree.diameter) * seed.child(0).range(0.5, 1.5);
  double lasts = std::log(10.0) / species.decay * std::clamp(std::sqrt(tree.diameter / 0.3), 0.2, 1.6);
  if (death.cause == DeathCause::cut) snag = lasts = 0;
  auto f = [](double x) { return static_cast<float>(x); };
  life.cause = death.cause;
  life.died = f(died), life.fell = f(died + snag),
  life.rotted = f(died + snag + lasts * seed.child(1).range(0.8, 1.2));
  life.azimuth = f(death.azimuth), life.broken = f(death.broken);
  note(now, tree, static_cast<double>(life.died));
  if (death.cause != DeathCause::cut)
    now.logs.push_back({tree.life, tree.x, tree.z, death.azimuth, tree.height - death.broken, tree.diameter,
                        static_cast<double>(life.fell), static_cast<double>(life.rotted),
                        falls_at_once && death.broken == 0});
}

/// Storms blow mostly to one side. The strongest gust of a year is of Gumbel's distribution: about 36 m/s in
/// fifty years.
YearGust gust_of(const StandNow& now, int year, Seed seed) {
  double natural =
      std::sqrt(now.options.storms) * (24 - 3.2 * std::log(-std::log(std::max(seed.child(0).unit(), 1e-12))));
  YearGust gust{natural, now.wind + 0.4 * seed.child(1).normal()};
  for (const StandEvent& event : now.options.events)
    if (event.year == year) gust.speed = storm_gust(gust.speed, event.storm);
  return gust;
}

/// How each of the trees ends this year.
std::vector<TreeDeath> deaths_of(const StandNow& now, const Canopy& canopy, int year, Seed seed) {
  std::vector<TreeDeath> deaths(now.trees.size());
  double snow = -std::log(1 - seed.child("snow").unit()) * now.options.storms;
  parallel_for(deaths.size(), [&](std::size_t i) {
    const StandTree& tree = now.trees[i];
    const TreeSpecies& species = now.species[tree.species];
    deaths[i] = quiet_death(tree, species, year, seed.child("quiet", tree.life));
    if (deaths[i].cause == DeathCause::none)
      deaths[i] = snow_death(tree, species, snow, seed.child("snow", tree.life + 1));
    for (const StandEvent& event : now.options.events)
      if (event.year == year && event.cut == species.name &&
          seed.child("cut", tree.life).unit() < event.share)
        deaths[i] = {.cause = DeathCause::cut};
  });
  add_storm_deaths(deaths, now.trees, now.species, canopy, gust_of(now, year, seed.child("gust")),
                   seed.child("blow"));
  return deaths;
}

/// Storms come at the end of a year, other deaths at any time of it.
void remove_dead(StandNow& now, const std::vector<TreeDeath>& deaths, int year, Seed seed) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < now.trees.size(); ++i) {
    const StandTree& tree = now.trees[i];
    if (deaths[i].cause == DeathCause::none) {
      now.trees[kept++] = tree;
      continue;
    }
    Seed own = seed.child(tree.life);
    bool stormy = deaths[i].cause == DeathCause::storm || deaths[i].cause == DeathCause::struck;
    double died = year - (stormy ? 0.1 : own.child(2).unit());
    bury(now, tree, deaths[i], died, own);
  }
  now.trees.resize(kept);
}

/// What is pruned at the beginning of a year.
void prune_limbs(StandNow& now, int year) {
  for (const StandEvent& event : now.options.events) {
    if (event.year != year || !event.pruned) continue;
    for (StandTree& tree : now.trees)
      if (event.pruned == now.species[tree.species].name)
        tree.crown_base = std::max(tree.crown_base, std::min(event.below, kMostPruned * tree.height));
  }
}

void step(StandNow& now, int year) {
  Seed seed = now.seed.child("year", static_cast<std::uint64_t>(year));
  prune_limbs(now, year);
  Canopy canopy = canopy_of(now.trees, now.species, now.grid);
  // What dies in a year has not grown in it.
  remove_dead(now, deaths_of(now, canopy, year, seed), year, seed.child("dead"));
  parallel_for(now.trees.size(),
               [&](std::size_t i) { grow_year(now.trees[i], now.species[now.trees[i].species], canopy); });
  std::vector<Recruit> recruits;
  if (now.options.seeding) {
    std::erase_if(now.logs, [&](const StandLog& log) { return log.rotted < year; });
    SeedBed bed = seed_bed(now.grid, now.logs, year);
    sow_year(now.seedlings, now.trees, now.species, seed.child("sow"));
    recruits = grow_seedlings(now.seedlings, now.species, {canopy, bed, now.logs, now.trees, now.site}, year,
                              seed.child("seedlings"));
  }
  if (year % 5 == 0 || year == now.options.years)
    for (const StandTree& tree : now.trees) note(now, tree, year);
  for (const Recruit& recruit : recruits) add_tree(now, recruit, year);
}

/// Brings together the sizes of each life, which were noted in the order of time.
void gather_sizes(StandHistory& history, const std::vector<NotedSize>& noted) {
  for (const NotedSize& n : noted) ++history.lives[n.life].count;
  std::uint32_t first = 0;
  for (TreeLife& life : history.lives) life.first = first, first += life.count, life.count = 0;
  history.sizes.resize(noted.size());
  for (const NotedSize& n : noted) {
    TreeLife& life = history.lives[n.life];
    history.sizes[life.first + life.count++] = n.size;
  }
}

}  // namespace

StandLand level_land() {
  return [](double, double) { return StandGround{}; };
}

StandHistory simulate_stand(const StandOptions& options, const StandLand& land, Seed seed) {
  StandGrid grid = grid_of(options.area, options.cell);
  StandNow now{.options = options,
               .seed = seed,
               .grid = grid,
               .species = options.species,
               .seedlings = Seedlings(grid, options.species.size())};
  now.site = sites(options, grid, land);
  now.wind = seed.child("wind").range(0, 2 * kPi);
  plant(now);
  for (int year = 1; year <= options.years; ++year) step(now, year);
  StandHistory history{
      .area = Vec2(static_cast<float>(grid.columns * grid.cell), static_cast<float>(grid.rows * grid.cell)),
      .years = options.years,
      .species = options.species,
      .lives = std::move(now.lives)};
  gather_sizes(history, now.noted);
  return history;
}

}  // namespace frond
