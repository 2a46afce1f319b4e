#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "dynamics/lives.h"
#include "dynamics/reef_floor.h"

namespace frond {

namespace {

constexpr double kRecruit = 0.01;    // metres, radius of a colony of a year
constexpr double kBed = 2e5;         // Pa, tensile strength of the ground (Madin 2005)
constexpr double kWater = 1025;      // kg/m3
constexpr double kNarrow = 0.05;     // metres of diameter over which the deaths of the young become fewer
constexpr double kLost = 0.2;        // share of its widest radius below which an overgrown colony dies
constexpr double kSmothering = 0.4;  // share of the youngest that thickets of algae kill in a year
constexpr double kAlgaeOver = 0.1;   // 1/year: rate at which macroalgae overgrow colonies, a of Mumby 2007
constexpr double kShadeDeath = 0.3;  // share of those that die in a year without any light
constexpr double kLooseDeath = 0.6;  // share of the youngest that die in a year on loose rubble
constexpr double kFragment = 0.3;    // radius of a fragment, over that of its colony
constexpr double kBreaks = 0.4;      // share of the waves that dislodge a colony from which on it breaks

/// Colonies that die in a year.
struct ColonyEnd {
  ColonyDeath cause = ColonyDeath::none;
  double died = 0, azimuth = 0, rolled = 0;
};

/// A skeleton that becomes rubble.
struct Skeleton {
  double gone = 0, x = 0, z = 0, area = 0;
};

/// The reef as it goes from year to year.
struct ReefNow {
  const ReefOptions& options;
  Seed seed;
  std::span<const ColonySpecies> species;
  ReefFloor floor;
  std::vector<Colony> colonies{};
  std::vector<Skeleton> skeletons{};
  std::vector<ColonyLife> lives{};
  std::vector<NotedSize<ColonySize>> noted{};
  ReefYear last{};
  double waves = 0;  // azimuth to which they run
};

ColonySize size_of(const Colony& c, double year) {
  auto f = [](double x) { return static_cast<float>(x); };
  return {f(year), f(c.radius), f(c.height)};
}

/// The strongest of a year's events of a kind.
double greatest(const ReefOptions& options, int year, double ReefEvent::*of) {
  double most = 0;
  for (const ReefEvent& event : options.events)
    if (event.year == year) most = std::max(most, event.*of);
  return most;
}

double area_of(const Colony& c) { return kPi * c.radius * c.radius; }

/// A colony that is there from a year on; where it has settled, as the dot that it was a year before.
void add_colony(ReefNow& now, Colony colony, double year, bool settled) {
  colony.life = static_cast<std::uint32_t>(now.lives.size());
  colony.born = settled ? year - 1 : year, colony.widest = colony.radius;
  ColonyLife life;
  life.species = colony.species;
  life.x = static_cast<float>(colony.x), life.z = static_cast<float>(colony.z);
  life.born = static_cast<float>(colony.born);
  now.lives.push_back(life);
  now.noted.push_back({colony.life, size_of(colony, year)});
  if (settled) now.noted.back().size = {.year = life.born, .radius = 1e-3f, .height = 1e-3f};
  now.colonies.push_back(colony);
}

/// Adds those of some colonies, in their order, that do not touch others.
void add_where_free(ReefNow& now, std::span<const Colony> wanted, double year, bool settled) {
  ColonyGrid there(now.colonies, now.options.area), fresh(wanted, now.options.area);
  std::size_t before = now.colonies.size();
  std::vector<char> kept(wanted.size(), false);
  for (std::uint32_t i = 0; i < wanted.size(); ++i) {
    const Colony& own = wanted[i];
    ColonyShape shape = shape_of(now.species[own.species], own.radius, own.height);
    bool free = true;
    auto touch = [&](const Colony& other) {
      ColonyShape beside = shape_of(now.species[other.species], other.radius, other.height);
      free = free && room_between(shape, beside, std::hypot(own.x - other.x, own.z - other.z)) >= 0;
    };
    there.each_near(own.x, own.z, own.radius, [&](std::uint32_t j) { touch(now.colonies[j]); });
    fresh.each_near(own.x, own.z, own.radius, [&](std::uint32_t j) {
      if (j < i && kept[j]) touch(wanted[j]);
    });
    kept[i] = free;
  }
  now.colonies.reserve(before + wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (kept[i]) add_colony(now, wanted[i], year, settled);
}

Colony colony_at(const ReefNow& now, std::uint32_t species, double radius, Seed seed) {
  auto wide = static_cast<double>(now.options.area.x), deep = static_cast<double>(now.options.area.y);
  const ColonySpecies& kind = now.species[species];
  double height = std::clamp(2 * radius * kind.slenderness, 0.003, kind.tallest);
  return {.species = species,
          .x = seed.child(0).range(-0.5, 0.5) * wide,
          .z = seed.child(1).range(-0.5, 0.5) * deep,
          .radius = radius,
          .height = height};
}

void plant(ReefNow& now) {
  auto area = static_cast<double>(now.options.area.x) * static_cast<double>(now.options.area.y);
  std::vector<Colony> wanted;
  for (std::size_t p = 0; p < now.options.planted.size(); ++p) {
    const Outplant& plants = now.options.planted[p];
    for (std::uint32_t s = 0; s < now.species.size(); ++s) {
      if (now.species[s].name != plants.name) continue;
      auto count = static_cast<std::uint64_t>(std::llround(plants.density * area));
      for (std::uint64_t i = 0; i < count; ++i)
        wanted.push_back(colony_at(now, s, plants.diameter / 2, now.seed.child("planted", p).child(i)));
    }
  }
  add_where_free(now, wanted, 0, false);
}

/// Larvae settle on hard ground without macroalgae, best on coralline algae (Harrington et al. 2004).
void settle(ReefNow& now, int year, Seed seed) {
  auto area = static_cast<double>(now.options.area.x) * static_cast<double>(now.options.area.y);
  std::vector<Colony> wanted;
  for (std::uint32_t s = 0; s < now.species.size(); ++s) {
    const ColonySpecies& kind = now.species[s];
    Seed own = seed.child("larvae", s);
    // Supply differs much between years (Hughes et al. 2000).
    double supply = std::exp(0.5 * own.child("supply").normal() - 0.125);
    double expected = supply * (kind.arrival + kind.larvae * now.last.cover[s]) * area;
    auto count = static_cast<std::uint64_t>(expected + own.child("part").unit());
    for (std::uint64_t i = 0; i < count; ++i) {
      Seed larva = own.child(i);
      Colony colony = colony_at(now, s, kRecruit, larva);
      const FloorCell& ground = now.floor.at(colony.x, colony.z);
      double crust = ground.free > 0 ? ground.coralline / ground.free : 0;
      double suits = (1 - ground.rubble) * (1 - ground.thicket()) * (0.6 + crust);
      if (larva.child(2).unit() < suits) wanted.push_back(colony);
    }
  }
  add_where_free(now, wanted, year, true);
}

/// Deaths of the year's course, apart from those by competition, heat and waves.
ColonyEnd quiet_death(const ReefNow& now, const Colony& c, double light, int year, Seed seed) {
  const ColonySpecies& kind = now.species[c.species];
  const FloorCell& ground = now.floor.at(c.x, c.z);
  double young = std::exp(-2 * c.radius / kNarrow);
  double shaded = kShadeDeath * (1 - light_response(kind, light));
  double smothered = kSmothering * ground.thicket() * young, loose = kLooseDeath * ground.rubble * young;
  double chance = seed.child(0).unit(), died = year - seed.child(1).range(0.2, 1);
  if (chance < shaded) return {ColonyDeath::shaded, died};
  if (chance < shaded + smothered) return {ColonyDeath::algae, died};
  double background = std::lerp(kind.death, kind.young_death, young) + loose;
  return {chance < shaded + smothered + background ? ColonyDeath::background : ColonyDeath::none, died};
}

/// A colony takes its end: its life is closed, its skeleton stands or has been rolled away.
void bury(ReefNow& now, const Colony& c, const ColonyEnd& end, Seed seed) {
  const ColonySpecies& kind = now.species[c.species];
  ColonyLife& life = now.lives[c.life];
  auto f = [](double x) { return static_cast<float>(x); };
  // What is small is gone soon; what has been rolled breaks up in a year or two.
  double stands = kind.skeleton * std::min(1.0, c.radius / 0.1) * seed.child(2).range(0.6, 1.4);
  if (end.cause == ColonyDeath::storm) stands = std::min(stands, seed.child(2).range(0.5, 2));
  if (end.cause == ColonyDeath::overgrown) stands = 0;
  life.cause = end.cause, life.died = f(end.died), life.gone = f(end.died + stands);
  life.azimuth = f(end.azimuth), life.rolled = f(end.rolled);
  now.noted.push_back({c.life, size_of(c, static_cast<double>(life.died))});
  if (kind.rubble > 0 && end.cause != ColonyDeath::overgrown)
    now.skeletons.push_back({end.died + (end.cause == ColonyDeath::storm ? 0 : stands),
                             c.x + end.rolled * std::sin(end.azimuth),
                             c.z + end.rolled * std::cos(end.azimuth), kind.rubble * area_of(c)});
}

void remove_dead(ReefNow& now, const std::vector<ColonyEnd>& ends, Seed seed) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < now.colonies.size(); ++i) {
    if (ends[i].cause == ColonyDeath::none)
      now.colonies[kept++] = now.colonies[i];
    else
      bury(now, now.colonies[i], ends[i], seed.child(now.colonies[i].life));
  }
  now.colonies.resize(kept);
}

/// Takes a share of a colony's area.
void injure(Colony& c, double share) { c.radius *= std::sqrt(1 - std::clamp(share, 0.0, 0.95)); }

/// A year's growth; colonies that are overgrown end, others are injured.
void grow(ReefNow& now, std::span<const double> light, const ColonyGrid& grid, int year, Seed seed) {
  std::vector<double> vigour(now.colonies.size());
  for (std::size_t i = 0; i < vigour.size(); ++i) {
    const Colony& c = now.colonies[i];
    vigour[i] = light_response(now.species[c.species], light[i]) *
                (1 - 0.5 * now.floor.at(c.x, c.z).thicket() * std::exp(-2 * c.radius / kNarrow));
  }
  grow_year(now.colonies, now.species, grid, vigour);
  std::vector<ColonyEnd> ends(now.colonies.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    Colony& c = now.colonies[i];
    if (c.radius < std::max(0.5 * kRecruit, kLost * c.widest)) {
      ends[i] = {ColonyDeath::overgrown, static_cast<double>(year)};
      c.radius = std::max(c.radius, 1e-4);
      continue;
    }
    // A third of the colonies are injured in a year.
    Seed own = seed.child("injury", c.life);
    if (own.child(0).unit() < 1 / 3.0)
      injure(c, 3 * own.child(1).range(0, 2) * now.species[c.species].injury);
    injure(c, kAlgaeOver * now.floor.at(c.x, c.z).thicket());
  }
  remove_dead(now, ends, seed.child("overgrown"));
}

/// What a heat wave kills, and the part of the survivors that dies.
void bleach(ReefNow& now, double weeks, int year, Seed seed) {
  std::vector<ColonyEnd> ends(now.colonies.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    Colony& c = now.colonies[i];
    Seed own = seed.child(c.life);
    double chance = heat_death(now.species[c.species], weeks);
    if (own.child(0).unit() < chance)
      ends[i] = {ColonyDeath::heat, year - own.child(1).range(0.15, 0.45)};
    else
      injure(c, chance * own.child(2).unit());
  }
  remove_dead(now, ends, seed);
}

/// Speed of the strongest waves of a year at the floor, m/s: Gumbel-distributed, or a storm's.
double waves_of(const ReefNow& now, int year, Seed seed) {
  double natural = kOrdinaryWaves - 0.25 * std::log(-std::log(std::max(seed.unit(), 1e-12)));
  double ordinary = std::sqrt(now.options.storms) * natural;
  double storm = greatest(now.options, year, &ReefEvent::storm);
  return ordinary < kWorstWaves ? ordinary + storm * (kWorstWaves - ordinary) : ordinary;
}

/// Waves dislodge colonies whose shape factor is above the dislodgement mechanical threshold, the strength of
/// the ground over the waves' pressure (Madin and Connolly 2006); weaker waves break what is brittle.
/// Fragments of some live on where they come to lie.
void storm(ReefNow& now, int year, Seed seed) {
  double speed = waves_of(now, year, seed.child("waves"));
  double toward = now.waves + 0.3 * seed.child("toward").normal();
  std::vector<ColonyEnd> ends(now.colonies.size());
  std::vector<Colony> fragments;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    Colony& c = now.colonies[i];
    const ColonySpecies& kind = now.species[c.species];
    Seed own = seed.child(c.life);
    double ground = kBed * std::exp(0.4 * now.seed.child("ground", c.life).normal());
    double load = shape_factor_at(kind, 2 * c.radius) * kWater * speed * speed / ground;
    if (load < 1) {
      if (double more = (load - kBreaks) / (1 - kBreaks); more > 0 && kind.rubble > 0) {
        double share = 0.5 * more * own.child(0).unit();
        now.floor.strew(c.x, c.z, share * kind.rubble * area_of(c));
        injure(c, share);
      }
      continue;
    }
    // Light pieces are carried farther.
    ends[i] = {ColonyDeath::storm, year - 0.1, toward + 0.4 * own.child(1).normal(),
               (0.3 + 0.3 * speed) * own.child(2).range(0.5, 1.5) * (kind.foot < 1 ? 1 : 0.3)};
    if (own.child(3).unit() >= kind.reattach) continue;
    Colony piece = c;
    piece.x += ends[i].rolled * std::sin(ends[i].azimuth);
    piece.z += ends[i].rolled * std::cos(ends[i].azimuth);
    piece.radius *= kFragment, piece.height *= kFragment;
    bool inside = std::abs(2 * piece.x) < static_cast<double>(now.options.area.x) &&
                  std::abs(2 * piece.z) < static_cast<double>(now.options.area.y);
    if (inside && piece.radius >= kRecruit) fragments.push_back(piece);
  }
  remove_dead(now, ends, seed.child("rolled"));
  add_where_free(now, fragments, year, false);
}

void crumble(ReefNow& now, int year) {
  for (const Skeleton& s : now.skeletons)
    if (s.gone <= year) now.floor.strew(s.x, s.z, s.area);
  std::erase_if(now.skeletons, [&](const Skeleton& s) { return s.gone <= year; });
}

void step(ReefNow& now, int year) {
  Seed seed = now.seed.child("year", static_cast<std::uint64_t>(year));
  std::vector<double> light = light_on(now.colonies, now.species, ColonyGrid(now.colonies, now.options.area));
  std::vector<ColonyEnd> ends(now.colonies.size());
  parallel_for(ends.size(), [&](std::size_t i) {
    ends[i] = quiet_death(now, now.colonies[i], light[i], year, seed.child("quiet", now.colonies[i].life));
  });
  // What dies in a year has not grown in it.
  std::size_t kept = 0;
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (ends[i].cause == ColonyDeath::none) light[kept++] = light[i];
  remove_dead(now, ends, seed.child("dead"));
  grow(now, light, ColonyGrid(now.colonies, now.options.area), year, seed.child("grow"));
  // Larvae come in spring, heat and storms in summer.
  if (now.options.settling) settle(now, year, seed.child("settle"));
  if (double weeks = greatest(now.options, year, &ReefEvent::heat); weeks > 0)
    bleach(now, weeks, year, seed.child("heat"));
  storm(now, year, seed.child("storm"));
  crumble(now, year);
  now.floor.grow_year(now.options);
  now.last = now.floor.survey(now.colonies, now.species);
  for (const Colony& c : now.colonies)
    if (c.born < year) now.noted.push_back({c.life, size_of(c, year)});
}

}  // namespace

ReefHistory simulate_reef(const ReefOptions& options, Seed seed) {
  ReefNow now{.options = options, .seed = seed, .species = options.species, .floor = ReefFloor(options.area)};
  now.waves = seed.child("waves").range(0, 2 * kPi);
  plant(now);
  now.last = now.floor.survey(now.colonies, now.species);
  ReefHistory history{.area = options.area,
                      .years = options.years,
                      .species = options.species,
                      .events = options.events,
                      .lives = {}};
  history.course.push_back(now.last);
  for (int year = 1; year <= options.years; ++year) {
    step(now, year);
    history.course.push_back(now.last);
  }
  history.lives = std::move(now.lives);
  gather_sizes(history, now.noted);
  return history;
}

}  // namespace frond
