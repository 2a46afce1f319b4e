#pragma once

#include "dress/describe.h"
#include "organisms/tree/tree.h"

// The properties of trees, as presets spell them; see preset/describe.h.

namespace frond {

inline constexpr Choice<Sharing> kSharings[] = {
    {"forks", Sharing::borchert_honda, "at each fork in proportion to light and by apical control"},
    {"priority", Sharing::priority, "along each axis, to what has most light first"}};

inline constexpr Choice<Fading> kFadings[] = {
    {"diffuse", Fading::diffuse,
     "down to the ground, spreading; under a roof of leaves as Beer and Lambert have it"},
    {"geometric", Fading::geometric, "a pyramid of cells, by base to the power of minus the depth"},
    {"even", Fading::even, "a pyramid of cells, evenly, by the volume of wood and leaves in a cell"}};

inline constexpr Choice<SprigKind> kSprigKinds[] = {
    {"oval", SprigKind::oval, "simple leaves along a twig"},
    {"lobed", SprigKind::lobed, "the same with lobes, as on oaks"},
    {"narrow", SprigKind::narrow, "long and narrow, as on willows"},
    {"needles", SprigKind::needles, "all round a twig"},
    {"feather", SprigKind::feather, "one leaf of many leaflets, as on acacias"}};

template <class Visitor>
void describe(Visitor& v, Wood& w) {
  v.number("exponent", w.exponent, {.min = 1.5, .max = 4},
           "n of the pipe model; the less, the thicker the stem");
  v.number("twig_radius", w.twig_radius, {.min = 0.0002, .max = 0.1, .unit = "m"}, "Of a tip");
  v.number("density", w.density, {.min = 50, .max = 2000, .unit = "kg/m3"}, "Of green wood");
  v.number("strength", w.strength, {.min = 1e5, .max = 1e9, .unit = "Pa"},
           "Stress at which sound wood breaks");
  v.number("stiffness", w.stiffness, {.min = 1e7, .max = 1e11, .unit = "Pa"},
           "The less, the more new shoots sag");
  v.number("leaf_mass", w.leaf_mass, {.min = 0, .max = 20, .unit = "kg/m2"}, "Of leaves");
  v.number("deadwood", w.deadwood, {.min = 0.1, .max = 200, .unit = "years"},
           "How long a dead twig stays; thicker wood stays longer");
}

template <class Visitor>
void describe(Visitor& v, Species& s) {
  v.number("internode", s.internode, {.min = 0.005, .max = 2, .unit = "m"},
           "Length of an ordinary internode");
  v.integer("longest_shoot", s.longest_shoot, {.min = 1, .max = 60},
            "Internodes of a shoot in a year, at most");
  v.integer("longest_branch_shoot", s.longest_branch_shoot, {.min = 0, .max = 60},
            "The same on branches; 0: as on the stem");
  v.angle("branching_angle", s.branching_angle, {.min = 0, .max = 150},
          "Between a shoot and the axis it leaves");
  v.angle("angle_jitter", s.angle_jitter, {.min = 0, .max = 60}, "Random change of it, either way");
  v.angle("phyllotaxis", s.phyllotaxis, {.min = 0, .max = 360}, "From bud to bud round the stem");
  v.angle("branch_phyllotaxis", s.branch_phyllotaxis, {.min = 0, .max = 360},
          "The same on branches; 180 makes flat sprays");
  v.integer("whorl", s.whorl, {.min = 0, .max = 60},
            "Only so many last buds of the stem's shoots sprout; 0: all");
  v.angle("wander", s.wander, {.min = 0, .max = 60}, "Random bend from internode to internode");
  v.choice("sharing", s.sharing, kSharings, "How buds come by what light brings");
  v.number("vigour", s.vigour, {.min = 0.1, .max = 20}, "Internodes a year for each bud in full light");
  v.number("apical_control", s.apical_control, {.min = 0.02, .max = 0.98},
           "0.45 bushy, 0.6, 0.85 a leading stem");
  v.number("apical_control_old", s.apical_control_old, {.min = 0.02, .max = 0.98},
           "What it becomes with age");
  v.number("branch_control", s.branch_control, {.min = -0.9, .max = 0.9}, "Added to it on branches");
  v.number("maturity", s.maturity, {.min = 0.5, .max = 1000, .unit = "years"}, "Until it has become so");
  v.number("light_pull", s.light_pull, {.min = 0, .max = 3}, "How far shoots turn to the light");
  v.number("tropism", s.tropism, {.min = -2, .max = 3}, "Upward pull of the stem");
  v.number("branch_tropism", s.branch_tropism, {.min = -2, .max = 3}, "Upward pull of branches");
  v.number("spread", s.spread, {.min = 0, .max = 1}, "How far branches are held level");
  v.number("droop", s.droop, {.min = 0, .max = 2},
           "Downward pull for each order of branching after the first");
  v.number("shade_tolerance", s.shade_tolerance, {.min = 0, .max = 1}, "0 sheds what is shaded, 1 keeps it");
  v.number("leaf_area", s.leaf_area, {.min = 0, .max = 1, .unit = "m2"},
           "Of an internode's leaves; what shades");
  v.integer("leaf_years", s.leaf_years, {.min = 1, .max = 20}, "How long an internode bears leaves");
  v.integer("bud_years", s.bud_years, {.min = 0, .max = 200}, "How long a bud may sleep");
  v.number("clear_trunk", s.clear_trunk, {.min = 0, .max = 60, .unit = "m"},
           "So much of the stem loses its branches as the tree grows up");
  v.number("height", s.height, {.min = 0.1, .max = 150, .unit = "m"}, "Near it growth ceases");
  v.number("dome", s.dome, {.min = 0, .max = 3},
           "How far width counts as height does: 0 flat tops, 1 round ones");
  v.number("lifespan", s.lifespan, {.min = 1, .max = 10000, .unit = "years"}, "Until it dies of age");
}

template <class Visitor>
void describe(Visitor& v, LightLaw& l) {
  v.number("voxel", l.voxel, {.min = 0.05, .max = 5, .unit = "m"}, "Side of a cell");
  v.choice("fading", l.fading, kFadings, "How shade fades below what casts it");
  v.integer("depth", l.depth, {.min = 1, .max = 15}, "Layers of a pyramid");
  v.number("base", l.base, {.min = 1, .max = 10}, "Of the fading from layer to layer");
  v.number("absorb", l.absorb, {.min = 0, .max = 10}, "Light that a layer of leaves takes");
}

template <class Visitor>
void describe(Visitor& v, Foliage& f) {
  v.choice("kind", f.sprig.kind, kSprigKinds, "What stands on an internode");
  v.number("size", f.size, {.min = 0, .max = 5, .unit = "m"}, "Of a sprig; 0: bare");
  v.number("size_variation", f.size_variation, {.min = 0, .max = 0.9}, "Random change of it, as a share");
  v.integer("leaves", f.sprig.leaves, {.min = 1, .max = 400},
            "On a sprig: leaves, needles or pairs of leaflets");
  v.number("leaf", f.sprig.leaf, {.min = 0.01, .max = 2}, "Length of one, as a share of the sprig's");
  v.number("width", f.sprig.width, {.min = 0.005, .max = 3}, "Of a leaf, as a share of its length");
  v.angle("open", f.sprig.open, {.min = 0, .max = 150}, "Between leaf and sprig");
  v.angle("spread", f.spread, {.min = 0, .max = 150}, "Between sprig and shoot");
  v.number("droop", f.sprig.hang, {.min = 0, .max = 1},
           "0 leaves lie in the light, 1 they hang from the sprig");
  v.number("hang", f.hang, {.min = 0, .max = 1}, "0 sprigs are held up, 1 they hang");
  v.list("colors", f.colors, Count{1, 64}, "One is picked for each sprig");
  v.color("second", f.second, "Of the veins");
  v.object("picture", f.picture,
           "Leaves as pictures in place of the kind; size and its variation are as above");
}

/// The weather of the years as presets group it.
struct Years {
  double wind, snow;
};

template <class Visitor>
void describe(Visitor& v, Years& y) {
  v.number("wind", y.wind, {.min = 0, .max = 150, .unit = "m/s"}, "The strongest gust of a year");
  v.number("snow", y.snow, {.min = 0, .max = 1000, .unit = "kg/m2"}, "The heaviest load of a year");
}

template <class Visitor>
void describe(Visitor& v, TreeParams& t) {
  v.integer("years", t.years, {.min = 1, .max = 500}, "How old it is in the end");
  v.object("habit", t.species, "How it grows");
  v.object("wood", t.species.wood, "Thickness and strength");
  v.object("light", t.light, "The field of light; that of the first tree counts for all");
  Years weather{t.wind, t.snow};
  v.object("weather", weather, "What loads the wood; that of the first tree counts for all");
  t.wind = weather.wind, t.snow = weather.snow;
  v.number("flare", t.flare, {.min = 0, .max = 4}, "How much wider the foot of the stem is");
  v.integer("roots", t.roots, {.min = 0, .max = 24}, "That run out from it above the ground");
  v.object("leaves", t.leaves, "Sprigs of leaves");
  v.object("bark", t.bark, "Surface of the branches");
  v.object("coat", t.coat, "A bark as a picture; branches are meshes then");
  v.object("season", t.season, "Its year");
  v.object("wave", t.wave, "Swaying in the wind");
  v.object("growth", t.growth, "When its years pass in the film");
}

}  // namespace frond
