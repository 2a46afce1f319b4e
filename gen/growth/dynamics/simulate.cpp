#include <algorithm>

#include "core/events.h"
#include "core/parallel.h"
#include "dynamics/lives.h"
#include "dynamics/seedlings.h"
#include "dynamics/stand.h"

namespace frond {

namespace {

constexpr double kAir = 1.2;  // kg/m3

/// How a tree dies, or none.
struct TreeDeath {
  DeathCause cause = DeathCause::none;
  double azimuth = 0;  ///< radians, the direction of its fall
  double broken = 0;   ///< metres, the height of what is left standing; 0: it falls with its roots
};

/// The strongest gust of a year.
struct YearGust {
  double speed = 0;   ///< m/s, in the open
  double toward = 0;  ///< azimuth to which it blows
};

/// Trees that grow too little die the likelier the less they bear shade, as in gap models; of age the chance
/// rises so that exp(-1) are left at their lifespan (Weibull, with shape 4).
TreeDeath quiet_death(const StandTree& tree, const TreeSpecies& species, double year, Seed seed) {
  double scale = 0.085 + 0.02 * (5 - species.tolerance);
  double suppressed = 0.3 * std::exp(-tree.vigour / scale);
  double age = (year - tree.born) / species.lifespan;
  double old = 4 * age * age * age / species.lifespan;
  double chance = seed.child(0).unit(), azimuth = 2 * kPi * seed.child(1).unit();
  if (chance < old) return {DeathCause::age, azimuth, 0};
  return {chance < old + suppressed + 0.001 ? DeathCause::suppressed : DeathCause::none, azimuth, 0};
}

/// kg of a fresh stem: 1.8 times its dry mass.
double fresh_mass(const TreeSpecies& species, const StandTree& tree) {
  return 1.8 * stem_mass(species, {.height = static_cast<float>(tree.height),
                                   .diameter = static_cast<float>(tree.diameter)});
}

/// Load of a gust on a tree over what its roots hold. The crown's drag is 0.35 up to 25 m/s and bends out of
/// the wind beyond (Rudnicki et al. 2004); bare crowns have 0.6 of it. Roots hold in proportion to the
/// fresh stem (Nicoll et al. 2006), more where the tree is stout. `exposure` is 1 in the open.
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

/// 1 in the open .. 0.2 in a closed stand, by how high the canopy is 5 to 40 m against the wind.
double exposure_of(const Canopy& canopy, const StandTree& tree, double toward) {
  double shelter = 0;
  for (int i = 1; i <= 8; ++i) {
    std::size_t cell = canopy.grid.at(tree.x - 5 * i * std::sin(toward), tree.z - 5 * i * std::cos(toward));
    shelter += std::min(static_cast<double>(canopy.top[cell]) / tree.height, 1.0) / 8;
  }
  return 1 - 0.8 * shelter;
}

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

/// Trees that a gust throws or breaks, and those that these strike as they fall; the dead stay as they are.
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

/// Slender evergreens that snow breaks; `load` is 1 in a mean winter (Päätalo et al. 1999: from 80 of
/// height over diameter on).
TreeDeath snow_death(const StandTree& tree, const TreeSpecies& species, double load, Seed seed) {
  double slender = std::max(tree.height / tree.diameter / 80 - 1, 0.0);
  double chance = 0.006 * load * load * slender * slender * (species.evergreen ? 1 : 0.1);
  if (tree.height < 3 || seed.child(0).unit() >= std::min(chance, 0.5)) return {};
  return {DeathCause::snow, 2 * kPi * seed.child(1).unit(), seed.child(2).range(0.2, 0.6) * tree.height};
}

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
  std::vector<NotedSize<TreeSize>> noted{};
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

/// Storms blow mostly to one side. A year's strongest gust is Gumbel-distributed: about 36 m/s in 50 years.
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
