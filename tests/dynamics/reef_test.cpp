#include "dynamics/reef.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/parallel.h"
#include "dynamics/reef_floor.h"
#include "dynamics/reef_plots.h"

namespace frond {
namespace {

/// A reef of all species on a square of so many metres.
ReefOptions whole_reef(float side, int years, std::vector<ReefEvent> events = {}) {
  ReefText text;
  text.area = Vec2(side), text.years = years;
  ReefOptions options = options_of(text);
  options.events = std::move(events);
  return options;
}

std::size_t index_of(ColonyName name) { return static_cast<std::size_t>(name); }

double cover_of(const ReefHistory& history, int year, ColonyName name) {
  return history.course[static_cast<std::size_t>(year)].cover[index_of(name)];
}

double cover_of(const ReefHistory& history, int year) {
  return history.course[static_cast<std::size_t>(year)].colony_cover();
}

/// Cover of each year, mean of three reefs.
std::vector<double> mean_cover(const ReefOptions& options) {
  std::vector<double> mean(static_cast<std::size_t>(options.years) + 1, 0);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    ReefHistory history = simulate_reef(options, Seed{seed});
    for (int year = 0; year <= options.years; ++year)
      mean[static_cast<std::size_t>(year)] += cover_of(history, year) / 3;
  }
  return mean;
}

/// Of the colonies of a species that lived before a year, are at least or at most so wide and do not die of
/// another cause, the share that dies of a cause in it.
double killed(const ReefHistory& history, int year, ColonyName name, ColonyDeath cause, double least,
              double most) {
  int all = 0, dead = 0;
  for (std::uint32_t i : living_at(history, year - 1)) {
    const ColonyLife& life = history.lives[i];
    double diameter = 2 * static_cast<double>(size_at(history, i, year - 1).radius);
    if (life.species != index_of(name) || diameter < least || diameter > most) continue;
    bool ends = life.died <= static_cast<float>(year);
    if (ends && life.cause != cause) continue;
    ++all, dead += ends;
  }
  EXPECT_GT(all, 5) << name_of(name);
  return dead / std::max(1.0, static_cast<double>(all));
}

/// Radius of what a colony takes at a height: nothing above its top, its foot below its crown.
double section_at(const ColonyShape& shape, double height) {
  return height >= shape.top ? 0 : height >= shape.under ? shape.radius : shape.foot;
}

TEST(Reef, NoTwoColoniesShareSpaceAndNoHeightIsCoveredTwice) {
  ReefHistory history = simulate_reef(whole_reef(6, 60, {{30, 0.6, 0}, {45, 0, 8}}), Seed{2});
  for (int year = 5; year <= 60; year += 5) {
    std::vector<std::uint32_t> living = living_at(history, year);
    std::vector<ColonyShape> shapes;
    for (std::uint32_t i : living) {
      ColonySize size = size_at(history, i, year);
      shapes.push_back(shape_of(history.species[history.lives[i].species], static_cast<double>(size.radius),
                                static_cast<double>(size.height)));
    }
    for (double height = 0.0025; height < 1; height += 0.005) {
      double taken = 0;
      for (std::size_t a = 0; a < living.size(); ++a) {
        double own = section_at(shapes[a], height);
        taken += kPi * own * own;
        for (std::size_t b = 0; own > 0 && b < a; ++b) {
          double other = section_at(shapes[b], height);
          if (other <= 0) continue;
          const ColonyLife &one = history.lives[living[a]], &two = history.lives[living[b]];
          auto apart = static_cast<double>(std::hypot(one.x - two.x, one.z - two.z));
          ASSERT_GE(apart, own + other - 1e-4) << "year " << year << ", height " << height;
        }
      }
      EXPECT_LE(taken, (6 + 2.6) * (6 + 2.6));  // crowns reach beyond the edge
    }
  }
}

TEST(Reef, SharesOfTheFloorAddUpToOne) {
  for (double grazing : {0.0, 0.6}) {
    ReefOptions options = whole_reef(6, 80, {{30, 0.8, 0}, {45, 0, 10}});
    options.grazing = grazing;
    for (const ReefYear& year : simulate_reef(options, Seed{1}).course) {
      for (double share : {year.colony_cover(), year.macroalgae, year.coralline, year.rubble, year.turf}) {
        EXPECT_GE(share, -1e-9);
        EXPECT_LE(share, 1);
      }
      EXPECT_NEAR(year.colony_cover() + year.macroalgae + year.coralline + year.rubble + year.turf, 1, 1e-9);
      EXPECT_GE(year.rugosity, 1 - 1e-9);
    }
  }
}

TEST(Reef, FloorsOfAnySizeAreSurveyedAsLargeAsTheyAre) {
  Colony mound{.species = 0, .x = 0, .z = 0, .radius = 0.3, .height = 0.3};
  const ColonySpecies kinds[] = {species(ColonyName::massive)};
  for (Vec2 area : {Vec2(1.2f, 1.2f), Vec2(1.01f, 1.9f), Vec2(2, 3)}) {
    ReefYear year = ReefFloor(area).survey(std::span(&mound, 1), kinds);
    EXPECT_NEAR(year.cover[0] * static_cast<double>(area.x * area.y), kPi * 0.09, 0.012) << area.x;
  }
}

TEST(Reef, RubbleLiesWhereItFalls) {
  for (Vec2 area : {Vec2(4), Vec2(4.2f, 3.9f)}) {
    ReefFloor floor(area);
    floor.strew(9, 0, 1), floor.strew(0, -9, 1);
    EXPECT_EQ(floor.survey({}, {}).rubble, 0);
    floor.strew(0.1, 0.1, 1);
    EXPECT_NEAR(floor.survey({}, {}).rubble * static_cast<double>(area.x * area.y), 1, 1e-5);
  }
}

/// Linear extension by growth form: Pratchett et al. 2015; soft corals Fabricius 1995, sponges McMurray 2008.
TEST(Reef, SoleColoniesGrowAtPublishedRates) {
  struct Row {
    ColonyName name;
    double least, most;  // cm a year
  };
  const Row rows[] = {
      {ColonyName::tabular, 3, 10},  {ColonyName::branching, 5, 16}, {ColonyName::bushy, 1.5, 5},
      {ColonyName::massive, 0.5, 2}, {ColonyName::brain, 0.4, 1.2},  {ColonyName::encrusting, 1, 3},
      {ColonyName::foliose, 1.5, 6}, {ColonyName::soft, 0.3, 2},     {ColonyName::sponge, 0.5, 2.5}};
  for (const Row& row : rows) {
    ReefOptions options;
    options.area = {5, 5}, options.years = 3, options.settling = false, options.storms = 0;
    options.species = {species(row.name)};
    options.species[0].death = options.species[0].young_death = options.species[0].injury = 0;
    options.planted = {{row.name, 0.04, 0.15}};
    ReefHistory history = simulate_reef(options, Seed{1});
    ASSERT_EQ(history.lives.size(), 1u);
    auto grown = 100 * static_cast<double>(size_at(history, 0, 3).radius - size_at(history, 0, 0).radius) / 3;
    EXPECT_GE(grown, row.least) << name_of(row.name);
    EXPECT_LE(grown, row.most) << name_of(row.name);
  }
}

/// Scott Reef came from 9 to 44 percent of cover within 12 years (Gilmour et al. 2013); reefs of the Great
/// Barrier Reef took about as long (Halford et al. 2004).
TEST(Reef, CoverComesBackInAboutADecadeAndAHalf) {
  std::vector<double> cover = mean_cover(whole_reef(12, 56, {{40, 0, 9}}));
  EXPECT_GT(cover[39], 0.4);
  EXPECT_LT(cover[39], 0.8);
  EXPECT_LT(cover[40], 0.4 * cover[39]);
  EXPECT_LT(cover[44], 0.7 * cover[39]);
  EXPECT_GT(cover[52], 0.65 * cover[39]);
  EXPECT_GT(cover[56], 0.8 * cover[39]);
}

/// Pioneers and survivors: Connell et al. 1997, Darling et al. 2012.
TEST(Reef, TablesComeFirstAndMassiveColoniesStay) {
  ReefHistory history = simulate_reef(whole_reef(14, 90, {{50, 0.8, 0}, {60, 0, 8}}), Seed{1});
  EXPECT_GT(cover_of(history, 15, ColonyName::tabular), 5 * cover_of(history, 15, ColonyName::massive));
  EXPECT_LT(cover_of(history, 60, ColonyName::tabular), 0.25 * cover_of(history, 49, ColonyName::tabular));
  EXPECT_GT(cover_of(history, 60, ColonyName::massive), 0.8 * cover_of(history, 49, ColonyName::massive));
  EXPECT_GT(cover_of(history, 90, ColonyName::massive), 2 * cover_of(history, 30, ColonyName::massive));
}

/// Hughes et al. 2018: nothing dies below 3 degree heating weeks, from 6 on assemblages change; Acropora and
/// Pocillopora lose most, massive Porites hardly any.
TEST(Reef, HeatKillsByDegreeHeatingWeeks) {
  for (const ColonySpecies& kind : colony_species()) {
    EXPECT_EQ(heat_death(kind, 3), 0) << name_of(kind.name);
    for (double weeks = 0; weeks < 20; weeks += 0.5)
      EXPECT_LE(heat_death(kind, weeks), heat_death(kind, weeks + 0.5)) << name_of(kind.name);
  }
  ReefHistory history = simulate_reef(whole_reef(14, 30, {{30, 0, 8}}), Seed{1});
  auto of = [&](ColonyName name) { return killed(history, 30, name, ColonyDeath::heat, 0.05, 9); };
  for (ColonyName name : {ColonyName::tabular, ColonyName::branching, ColonyName::bushy})
    EXPECT_GT(of(name), 0.65) << name_of(name);
  EXPECT_LT(of(ColonyName::massive), 0.15);
  EXPECT_LT(of(ColonyName::brain), 0.4);
  ReefHistory mild = simulate_reef(whole_reef(14, 30, {{30, 0, 4}}), Seed{1});
  EXPECT_LT(killed(mild, 30, ColonyName::tabular, ColonyDeath::heat, 0.05, 9), 0.35);
}

/// Madin and Connolly 2006: wide tables go, what is small or a mound stays. After the cyclone Yasi juveniles
/// were left (Lukoschek et al. 2013).
TEST(Reef, StormsDislodgeByShapeAndSize) {
  ReefHistory history = simulate_reef(whole_reef(14, 31, {{30, 0.8, 0}}), Seed{1});
  auto of = [&](ColonyName name, double least, double most) {
    return killed(history, 30, name, ColonyDeath::storm, least, most);
  };
  EXPECT_GT(of(ColonyName::tabular, 0.8, 9), 0.8);
  EXPECT_LT(of(ColonyName::tabular, 0, 0.15), 0.1);
  EXPECT_LT(of(ColonyName::massive, 0, 9), 0.02);
  EXPECT_GT(history.course[30].rubble, 1.3 * history.course[29].rubble);
  EXPECT_LT(history.course[30].rugosity, history.course[29].rugosity);
  for (const ColonyLife& life : history.lives) EXPECT_EQ(life.rolled > 0, life.cause == ColonyDeath::storm);
}

/// Mumby et al. 2007: where grazing is low, algae keep what a disturbance has freed.
TEST(Reef, WithoutGrazersAlgaeTakeWhatBecomesFree) {
  ReefOptions options = whole_reef(10, 60, {{40, 0, 12}});
  ReefHistory grazed = simulate_reef(options, Seed{1});
  options.grazing = 0.05;
  ReefHistory left = simulate_reef(options, Seed{1});
  EXPECT_LT(grazed.course[60].macroalgae, 0.1);
  EXPECT_GT(left.course[60].macroalgae, 0.6);
  EXPECT_GT(left.course[42].macroalgae, left.course[39].macroalgae + 0.05);
  EXPECT_GT(cover_of(grazed, 60), 2 * cover_of(left, 60));
}

/// On rubble that is not bound nothing lives long (Fox et al. 2003).
TEST(Reef, LooseRubbleHoldsBackRecovery) {
  ReefOptions options = whole_reef(10, 44, {{30, 1, 0}});
  options.binding = 0.5;
  double bound = mean_cover(options)[44];
  options.binding = 0;
  EXPECT_GT(bound, 1.3 * mean_cover(options)[44]);
}

TEST(Reef, IsTheSameAtAnyNumberOfThreadsAndInAnyOrderOfEvents) {
  std::vector<ReefEvent> events{{10, 0.5, 0}, {10, 0, 5}, {16, 0, 7}};
  limit_threads(1);
  ReefHistory alone = simulate_reef(whole_reef(5, 20, events), Seed{4});
  limit_threads(4);
  std::ranges::reverse(events);
  ReefHistory many = simulate_reef(whole_reef(5, 20, events), Seed{4});
  limit_threads(0);
  EXPECT_EQ(reef_csv(alone), reef_csv(many));
  ASSERT_EQ(alone.sizes.size(), many.sizes.size());
  EXPECT_EQ(std::memcmp(alone.sizes.data(), many.sizes.data(), alone.sizes.size() * sizeof(ColonySize)), 0);
  // What is to come changes nothing before it.
  ReefHistory calm = simulate_reef(whole_reef(5, 20), Seed{4});
  for (std::size_t year = 0; year < 10; ++year) EXPECT_EQ(alone.course[year].cover, calm.course[year].cover);
  EXPECT_NE(alone.course[10].cover, calm.course[10].cover);
}

TEST(Reef, LivesAreLivedInOrder) {
  ReefHistory history = simulate_reef(whole_reef(6, 40, {{20, 0.7, 0}, {30, 0, 8}}), Seed{3});
  for (std::uint32_t i = 0; i < history.lives.size(); ++i) {
    const ColonyLife& life = history.lives[i];
    ASSERT_GT(life.count, 0u);
    EXPECT_LE(life.born, life.died);
    EXPECT_LE(life.died, life.gone);
    EXPECT_EQ(life.died < ColonyLife::kNever, life.cause != ColonyDeath::none);
    for (std::uint32_t k = life.first + 1; k < life.first + life.count; ++k)
      EXPECT_LT(history.sizes[k - 1].year, history.sizes[k].year) << i;
    const ColonySize& last = history.sizes[life.first + life.count - 1];
    EXPECT_EQ(size_at(history, i, 1000).radius, last.radius);
    EXPECT_EQ(size_at(history, i, life.born - 1).radius, 0);
    EXPECT_LE(2 * static_cast<double>(last.radius), history.species[life.species].widest);
  }
}

TEST(Reef, RatesOfTheTableLieInTheirRangesAndAuthorsMayChangeThem) {
  for (const ColonySpecies& kind : colony_species())
    for (const ColonyRate& rate : colony_rates()) {
      EXPECT_GE(kind.*rate.at, rate.min) << name_of(kind.name) << ' ' << rate.name;
      EXPECT_LE(kind.*rate.at, rate.max) << name_of(kind.name) << ' ' << rate.name;
    }
  ReefText text;
  text.species.resize(2);
  text.species[0].name = ColonyName::brain, text.species[1].name = ColonyName::soft;
  for (std::size_t r = 0; r < kColonyRates; ++r)
    if (colony_rates()[r].name == "extension") text.species[1].rates[r] = 3.5;
  ReefOptions options = options_of(text);
  ASSERT_EQ(options.species.size(), 2u);
  EXPECT_EQ(options.species[0].extension, species(ColonyName::brain).extension);
  EXPECT_EQ(options.species[1].extension, 3.5);
  EXPECT_TRUE(reef_faults(text).empty());
  text.species.push_back(text.species[1]);
  text.planted = {{.name = ColonyName::massive}};
  Errors faults = reef_faults(text);
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0].where, "/species/2/name");
  EXPECT_EQ(faults[1].what, "\"massive\" is not among the species of the reef; expected one of them");
}

TEST(Reef, TellsItsFigures) {
  ReefHistory history = simulate_reef(whole_reef(4, 12, {{6, 0, 8}}), Seed{1});
  std::string csv = reef_csv(history);
  EXPECT_TRUE(
      csv.starts_with("year,tabular,branching,bushy,massive,brain,encrusting,foliose,soft,sponge,"
                      "colonies_cover,macroalgae,coralline,rubble,turf,colonies,rugosity\n0,0.00,"));
  EXPECT_EQ(std::ranges::count(csv, '\n'), 14);
  std::string svg = reef_svg(history, 9.5);
  for (const char* part : {"The reef in year 9.5: ", "Cover by species", "Ground between them", "Rugosity",
                           "Map, 4 x 4 m", ">tabular<", "stroke=\"#c0392b\""})
    EXPECT_NE(svg.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace frond
