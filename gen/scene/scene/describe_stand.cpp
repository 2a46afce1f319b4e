#include "scene/describe.h"

namespace frond {

namespace {

constexpr Choice<TreeName> kTreeNames[] = {
    {"birch", TreeName::birch, "silver birch, a pioneer on the wind"},
    {"aspen", TreeName::aspen, "a pioneer on the wind"},
    {"rowan", TreeName::rowan, "a small pioneer that birds sow"},
    {"oak", TreeName::oak, "long-lived, needs light, sown by jays"},
    {"pine", TreeName::pine, "Scots pine, needs light"},
    {"beech", TreeName::beech, "grows up in shade and casts it"},
    {"spruce", TreeName::spruce, "Norway spruce, bears shade, comes up on rotting logs"},
    {"fir", TreeName::fir, "silver fir, bears shade"}};

}  // namespace

void describe(Properties& v, TreeText& t) {
  v.shorthand("name");
  v.choice("name", t.name, kTreeNames, "The species; what is not given here is as in docs/stand.md");
  v.required("name");
  v.text("organism", t.organism,
         "Name of the organism that these trees are drawn as, one with `sown` and a `count` of 0; not given: "
         "they are not drawn");
  v.number("height", t.height, metres(2, 100), "Height of the tallest trees");
  v.number("girth_gain", t.girth_gain, {.min = 0.1, .max = 10, .unit = "cm"},
           "How much girth a tree in the open adds in a year");
  v.number("tolerance", t.tolerance, {.min = 1, .max = 5},
           "How well the species bears shade: 1 needs full light, 5 grows in deep shade");
  v.number("lifespan", t.lifespan, {.min = 10, .max = 3000, .unit = "years"},
           "Age by which two of three trees would have died of age alone");
  v.number("anchorage", t.anchorage, {.min = 1, .max = 10000, .unit = "N m/kg"},
           "Moment that the roots hold for each kilogram of the fresh stem");
  v.number("reach", t.reach, metres(0.5, 10000), "Median distance of the seeds from their tree");
  v.number("seeds", t.seeds, {.min = 0, .max = 1000},
           "Seedlings a year for each square metre of a crown, where all suits them");
  v.number("arrival", t.arrival, {.min = 0, .max = 1000},
           "Seedlings a year on each square metre from seeds that come from beyond the land");
  v.number("coldest", t.coldest, {.min = -5, .max = 25, .unit = "degrees"},
           "Mean temperature of the growing season at which the species no longer grows");
  v.number("moisture", t.moisture, kShare,
           "Moisture of the ground that the species likes best: 0 dry, 1 wet");
}

void describe(Properties& v, StandPlanting& p) {
  v.choice("name", p.name, kTreeNames, "The species that is planted");
  v.required("name");
  v.number("density", p.density, {.min = 1, .max = 20000, .unit = "trees a hectare"},
           "How many trees stand there at first, each at breast height");
}

void describe(Properties& v, StandText& s) {
  v.vector("area", s.area, metres(10, 1000), "How long the land is along x and along z");
  v.integer("years", s.years, {.min = 1, .max = 2000}, "How many years are simulated");
  v.vector("shown", s.shown, {.min = 0, .max = 2000, .unit = "years"},
           "The years that a film shows, first and last; not given: all that are simulated. A still shows "
           "the last");
  v.list("species", s.species, "The species that come up; not given: all that there are");
  v.list("planted", s.planted, "Trees that are planted at the beginning, at random places");
  v.boolean("seeding", s.seeding, "Whether trees come up by themselves");
  v.number("storms", s.storms, {.min = 0, .max = 4, .sense = "1 as in Central Europe, 0 none"},
           "Factor of the loads of the storms and the snow that come by themselves");
  v.number(
      "temperature", s.temperature, {.min = -5, .max = 30, .unit = "degrees"},
      "Mean temperature of the growing season at height 0 of the land; it falls by 6.5 degrees a kilometre");
  v.number("moisture", s.moisture, kShare, "Moisture of the ground: 0 dry, 1 wet");
}

}  // namespace frond
