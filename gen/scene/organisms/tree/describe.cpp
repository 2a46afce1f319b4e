#include "appearance/describe.h"
#include "organisms/describe_grammar.h"
#include "organisms/tree/tree.h"

namespace frond {

namespace {

constexpr Choice<Sharing> kSharings[] = {
    {"forks", Sharing::borchert_honda, "at each fork in proportion to light and by apical control"},
    {"priority", Sharing::priority, "along each axis, to what has most light first"}};

constexpr Choice<Fading> kFadings[] = {
    {"diffuse", Fading::diffuse,
     "down to the ground, spreading; under a roof of leaves as Beer and Lambert have it"},
    {"geometric", Fading::geometric, "a pyramid of cells, by base to the power of minus the depth"},
    {"even", Fading::even, "a pyramid of cells, evenly, by the volume of wood and leaves in a cell"}};

constexpr Choice<SprigKind> kSprigKinds[] = {
    {"oval", SprigKind::oval, "simple leaves along a twig"},
    {"lobed", SprigKind::lobed, "the same with lobes, as on oaks"},
    {"narrow", SprigKind::narrow, "long and narrow, as on willows"},
    {"needles", SprigKind::needles, "all round a twig"},
    {"feather", SprigKind::feather, "one leaf of many leaflets, as on acacias"}};

}  // namespace

void describe(Properties& v, Wood& w) {
  v.number("exponent", w.exponent, {.min = 1.5, .max = 4},
           "Exponent n of the pipe model; the smaller, the thicker the stem");
  v.number("twig_radius", w.twig_radius, {.min = 0.0002, .max = 0.1, .unit = "m"}, "Radius of a tip");
  v.number("density", w.density, {.min = 50, .max = 2000, .unit = "kg/m3"}, "Density of green wood");
  v.number("strength", w.strength, {.min = 1e5, .max = 1e9, .unit = "Pa"},
           "Stress at which sound wood breaks");
  v.number("stiffness", w.stiffness, {.min = 1e7, .max = 1e11, .unit = "Pa"},
           "Stiffness of the wood; the smaller, the more new shoots sag");
  v.number("leaf_mass", w.leaf_mass, {.min = 0, .max = 20, .unit = "kg/m2"},
           "Mass of a square metre of leaves");
  v.number("deadwood", w.deadwood, {.min = 0.1, .max = 200},
           "For how many growth cycles a dead twig stays on the tree; thicker wood stays longer");
}

void describe(Properties& v, Species& s) {
  v.number("internode", s.internode, {.min = 0.005, .max = 2, .unit = "m"},
           "Length of an ordinary internode, from bud to bud");
  v.number(
      "pace", s.pace, {.min = 0.05, .max = 4},
      "Growth cycles that it goes through in a year while it is young; one makes the shoots of a good year");
  v.number("youth", s.youth, {.min = 1, .max = 1000, .unit = "years"},
           "Age up to which it keeps that pace; after it a cycle takes the more years the older the tree is");
  v.integer("longest_shoot", s.longest_shoot, {.min = 1, .max = 60},
            "Number of internodes that a shoot grows in a cycle, at most");
  v.integer("longest_branch_shoot", s.longest_branch_shoot, {.min = 0, .max = 60},
            "The same for shoots on branches; 0 is as on the stem");
  v.angle("branching_angle", s.branching_angle, {.min = 0, .max = 150},
          "Angle between a new shoot and the axis that it leaves");
  v.angle("angle_jitter", s.angle_jitter, {.min = 0, .max = 60}, "Random change of that angle, either way");
  v.angle("phyllotaxis", s.phyllotaxis, {.min = 0, .max = 360},
          "Angle from one bud to the next round the stem");
  v.angle("branch_phyllotaxis", s.branch_phyllotaxis, {.min = 0, .max = 360},
          "The same on branches; 180 makes flat sprays");
  v.integer("whorl", s.whorl, {.min = 0, .max = 60},
            "Number of last buds on the stem's shoots that sprout; 0 is all of them");
  v.angle("wander", s.wander, {.min = 0, .max = 60}, "Random bend from internode to internode");
  v.choice("sharing", s.sharing, kSharings, "How buds share what the light brings");
  v.number("vigour", s.vigour, {.min = 0.1, .max = 20},
           "Number of internodes that a bud in full light grows in a cycle");
  v.number("apical_control", s.apical_control, {.min = 0.02, .max = 0.98},
           "How far the leading shoot goes before its side shoots: 0.45 bushy, 0.6 even, 0.85 a single stem");
  v.number("apical_control_old", s.apical_control_old, {.min = 0.02, .max = 0.98},
           "What apical_control becomes with age");
  v.number("branch_control", s.branch_control, {.min = -0.9, .max = 0.9},
           "What is added to apical_control on branches");
  v.number("maturity", s.maturity, {.min = 0.5, .max = 1000, .unit = "years"},
           "Age at which apical_control has become apical_control_old");
  v.number("light_pull", s.light_pull, {.min = 0, .max = 3}, "How far shoots turn toward the light");
  v.number("tropism", s.tropism, {.min = -2, .max = 3}, "Upward pull on the stem; negative pulls it down");
  v.number("branch_tropism", s.branch_tropism, {.min = -2, .max = 3},
           "Upward pull on branches; negative pulls them down");
  v.number("spread", s.spread, {.min = 0, .max = 1}, "How far branches are held level");
  v.number("droop", s.droop, {.min = 0, .max = 2},
           "Downward pull on branches, for each order of branching after the first");
  v.number("shade_tolerance", s.shade_tolerance, {.min = 0, .max = 1},
           "How much shade branches bear: 0 sheds what is shaded, 1 keeps it");
  v.number("leaf_area", s.leaf_area, {.min = 0, .max = 1, .unit = "m2"},
           "Area of one internode's leaves, which casts the shade");
  v.integer("leaf_years", s.leaf_years, {.min = 1, .max = 20},
            "For how many growth cycles an internode bears leaves");
  v.integer("bud_years", s.bud_years, {.min = 0, .max = 200},
            "For how many growth cycles a bud may sleep before it dies");
  v.number("clear_trunk", s.clear_trunk, {.min = 0, .max = 60, .unit = "m"},
           "Length of the stem that loses its branches as the tree grows up");
  v.number("height", s.height, {.min = 0.1, .max = 150, .unit = "m"}, "Height near which growth ceases");
  v.number("dome", s.dome, {.min = 0, .max = 3},
           "How far width counts toward the height: 0 makes flat tops, 1 round ones");
  v.number("lifespan", s.lifespan, {.min = 1, .max = 10000, .unit = "years"}, "Age at which it dies");
}

void describe(Properties& v, LightLaw& l) {
  v.number("voxel", l.voxel, {.min = 0.05, .max = 5, .unit = "m"}, "Side of a cell of the field of light");
  v.choice("fading", l.fading, kFadings, "How shade fades below what casts it");
  v.integer("depth", l.depth, {.min = 1, .max = 15},
            "Number of layers of the pyramid below a leaf. Needs fading other than diffuse");
  v.number("base", l.base, {.min = 1, .max = 10},
           "Factor by which shade fades from layer to layer. Needs \"fading\": \"geometric\"");
  v.number("absorb", l.absorb, {.min = 0, .max = 10}, "How much light a layer of leaves takes");
}

void describe(Properties& v, Foliage& f) {
  v.choice("kind", f.sprig.kind, kSprigKinds, "What stands on an internode");
  v.number("size", f.size, {.min = 0, .max = 5, .unit = "m"}, "Length of a sprig; 0 leaves the tree bare");
  v.number("size_variation", f.size_variation, {.min = 0, .max = 0.9},
           "Random change of the size, as a share of it");
  v.integer("leaves", f.sprig.leaves, {.min = 1, .max = 400},
            "Number of leaves, needles or pairs of leaflets on a sprig");
  v.number("leaf", f.sprig.leaf, {.min = 0.01, .max = 2}, "Length of one leaf as a share of the sprig's");
  v.number("width", f.sprig.width, {.min = 0.005, .max = 3}, "Width of a leaf as a share of its length");
  v.angle("open", f.sprig.open, {.min = 0, .max = 150}, "Angle between a leaf and its sprig");
  v.angle("spread", f.spread, {.min = 0, .max = 150}, "Angle between a sprig and its shoot");
  v.number("droop", f.sprig.hang, {.min = 0, .max = 1},
           "How far leaves hang from their sprig: 0 they lie in the light, 1 they hang");
  v.number("hang", f.hang, {.min = 0, .max = 1}, "How far sprigs hang: 0 they are held up, 1 they hang");
  v.list("colors", f.colors, Count{1, 64}, "Colours of the leaves; each sprig takes one of them");
  v.color("second", f.second, "Colour of the veins");
  v.object("picture", f.picture,
           "Leaves as pictures in place of the kind; size and size_variation are those above");
  v.aspect(Aspect::look, "kind", "leaves", "leaf", "width", "open", "droop", "colors", "second");
}

void describe(Properties& v, GrowthBudget& b) {
  v.shorthand("internodes");
  v.integer(
      "internodes", b.internodes, {.min = 0, .max = 100'000'000},
      "Number of internodes that may stand on all trees that grow together; 0 is as many as seconds allow");
  v.number(
      "seconds", b.seconds, {.min = 0, .max = 1e6, .unit = "s"},
      "Seconds of processor that growing may take, where internodes is 0; `frond generate` counts once how "
      "many internodes that is, and notes it in the film's folder");
}

/// The weather of the years as presets group it.
struct Years {
  double wind, snow;
};

void describe(Properties& v, Years& y) {
  v.number("wind", y.wind, {.min = 0, .max = 150, .unit = "m/s"}, "Speed of the strongest gust of a year");
  v.number("snow", y.snow, {.min = 0, .max = 1000, .unit = "kg/m2"}, "Heaviest load of snow of a year");
}

void describe(Properties& v, TreeParams& t) {
  v.integer("years", t.years, {.min = 1, .max = 500}, "Age of the tree in the end");
  v.object("budget", t.budget,
           "Growth ends with the last growth cycle that it allows, however many years are left; that of the "
           "scene's first tree counts for all");
  v.object("habit", t.species, "How it grows");
  v.object(
      "guide", t.guide,
      "A line that its stem follows, from the foot; past its end and on all branches it grows by its own "
      "laws");
  describe(v, t.along);
  v.object("wood", t.species.wood, "Thickness, weight and strength of the wood");
  v.object("light", t.light, "The field of light; that of the scene's first tree counts for all");
  Years weather{t.wind, t.snow};
  v.object("weather", weather, "What loads the wood; that of the scene's first tree counts for all");
  t.wind = weather.wind, t.snow = weather.snow;
  v.number(
      "anchorage", t.species.anchorage, {.min = 0, .max = 10000, .unit = "N m/kg"},
      "Moment that the roots hold for each kilogram of the stem; a tree whose load passes it falls. 0 holds "
      "any load");
  v.number("flare", t.flare, {.min = 0, .max = 4}, "How much wider the foot of the stem is, as a share");
  v.integer("roots", t.roots, {.min = 0, .max = 24}, "Number of roots that run out above the ground");
  v.number(
      "knots", t.knots, {.min = 0, .max = 4},
      "How far the stubs of boughs that fell stand out, until the stem has grown over them; 0 hides them");
  v.object("leaves", t.leaves, "The sprigs of leaves");
  v.object("bark", t.bark, "The plain surface of branches, of twigs in any case");
  v.object("coat", t.coat, "A picture of bark on the trunk and the larger branches, which are meshes then");
  v.object("season", t.season, "The course of the year for its leaves; without it they stay as they are");
  v.object("wave", t.wave, "Swaying in the wind");
  v.object("growth", t.growth, "When it grows in the film, all cycles in the same time");
  if (double pace = t.growth.years_a_second; pace > 0) t.growth.duration = t.years / pace;
  v.aspect(Aspect::shape, "growth");  // a tree stands as its years have left it by then
}

}  // namespace frond
