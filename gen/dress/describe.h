#pragma once

#include "dress/dress.h"
#include "geometry/girth.h"
#include "preset/reader.h"

// The properties of what organisms wear and how they move, as presets spell them; see preset/describe.h.

namespace frond {

inline constexpr Choice<SkinKind> kSkinKinds[] = {
    {"stony", SkinKind::stony, "raised cups with a pit in each, as on stony corals"},
    {"fan", SkinKind::fan, "fine and matt, as on sea fans and whips"},
    {"soft", SkinKind::soft, "furry with open polyps, as on soft corals"}};

inline constexpr Choice<BarkKind> kBarks[] = {{"bark", BarkKind::bark, "furrowed along the branch"},
                                              {"birch", BarkKind::birch, "smooth with dark bands"},
                                              {"stem", BarkKind::stem, "green stems of herbs"},
                                              {"ink", BarkKind::ink, "one matt colour"},
                                              {"metal", BarkKind::metal, "polished wire"},
                                              {"wax", BarkKind::wax, "smooth with soft highlights"},
                                              {"palm", BarkKind::palm, "rings across, the scars of leaves"}};

inline constexpr Choice<Tissue> kBladeTissues[] = {{"leaf", Tissue::leaf, "with veins"},
                                                   {"petal", Tissue::petal, "without"}};

inline constexpr Choice<GirthFrom> kGirths[] = {
    {"turtle", GirthFrom::turtle, "the turtle's widths, as diameters"},
    {"distance", GirthFrom::distance, "the way from a place to the farthest tip above it, through the curve"},
    {"pipe", GirthFrom::pipe,
     "what a branch carries: its radius to the power n is the sum of those it parts into"}};

inline constexpr Choice<LeafShape> kLeafShapes[] = {
    {"birch", LeafShape::birch, "toothed, pointed"},
    {"beech", LeafShape::beech, "an oval"},
    {"oak", LeafShape::oak, "round lobes"},
    {"maple", LeafShape::maple, "five pointed lobes"},
    {"ivy", LeafShape::ivy, "three to five lobes"},
    {"aspen", LeafShape::aspen, "nearly round, on a long stalk"},
    {"willow", LeafShape::willow, "long and narrow"},
    {"linden", LeafShape::linden, "a heart"},
    {"cherry", LeafShape::cherry, "a toothed oval"},
    {"ginkgo", LeafShape::ginkgo, "a fan"},
    {"own", LeafShape::own, "the radii under outline"}};

inline constexpr Choice<BarkPattern> kBarkPatterns[] = {
    {"furrowed", BarkPattern::furrowed, "long ridges, as on oaks"},
    {"plated", BarkPattern::plated, "plates between cracks, as on pines"},
    {"smooth", BarkPattern::smooth, "folds and short scars, as on beeches"},
    {"banded", BarkPattern::banded, "papery with dark bands, as on birches"}};

template <class Visitor>
void describe(Visitor& v, Pores& p) {
  v.number("cell", p.cell, {.min = 0.0005, .max = 1, .unit = "m"}, "From pore to pore");
  v.number("warp", p.warp, {.min = 0, .max = 1}, "How far the cells are warped");
  v.number("depth", p.depth, {.min = 0, .max = 3}, "How deep the pores look");
}

template <class Visitor>
void describe(Visitor& v, Tint& t) {
  v.color("base", t.base, "Colour of the skin");
  v.color("secondary", t.secondary, "Colour in the pores and grooves");
  v.angle("hue", t.hue, {.min = -360, .max = 360}, "Turns both colours round the colour wheel");
  v.number("saturation", t.saturation, {.min = 0, .max = 3}, "Factor");
  v.number("value", t.value, {.min = 0, .max = 3}, "Factor of the brightness");
  v.number("variation", t.variation, {.min = 0, .max = 0.9}, "How much single corals differ in brightness");
  v.number("young", t.young, {.min = 0, .max = 1}, "How much paler growing tips are");
  v.number("young_length", t.young_length, {.min = 0, .max = 10, .unit = "m"},
           "Below a tip, until the paleness is gone");
}

template <class Visitor>
void describe(Visitor& v, Skin& s) {
  v.choice("kind", s.kind, kSkinKinds, "What it is made of");
  v.object("pores", s.pores, "Pores");
  v.object("tint", s.tint, "Colours");
}

template <class Visitor>
void describe(Visitor& v, Growth& g) {
  v.number("start", g.start, {.min = -1e6, .max = 1e6, .unit = "s"}, "When it begins");
  v.number("duration", g.duration, {.min = 0, .max = 1e6, .unit = "s"},
           "How long it takes; 0: fully grown from the start");
  v.number("stagger", g.stagger, {.min = 0, .max = 1e6, .unit = "s"},
           "Single ones begin up to so much later");
  v.number("ripen", g.ripen, {.min = 0.01, .max = 2},
           "Share of the growth until a place has its full thickness");
}

template <class Visitor>
void describe(Visitor& v, Wave& w) {
  v.angle("amplitude", w.amplitude, {.min = 0, .max = 120}, "How far the tips are bent");
  v.number("speed", w.speed, {.min = 0, .max = 20, .unit = "1/s"}, "Swings a second");
  v.angle("phase", w.phase, {.min = -360, .max = 360},
          "Where in the swing the film begins; single corals differ");
  v.number("length", w.length, {.min = 0.01, .max = 1000, .unit = "m"},
           "From crest to crest along the current");
  v.direction("direction", w.direction, Across::xz, "Of the current; only x and z count");
  v.boolean("loop", w.loop, "Whole swings over the film, so that it can be repeated");
}

template <class Visitor>
void describe(Visitor& v, Food& f) {
  v.angle("strength", f.strength, {.min = 0, .max = 180}, "About how far whole branches bend toward it");
  v.number("reach", f.reach, {.min = 0.02, .max = 100, .unit = "m"}, "Nearer than this the pull fades");
  v.animated("position", f.position, {.min = -1000, .max = 1000, .unit = "m"},
             "Where the food is, or keyframes of it");
}

template <class Visitor>
void describe(Visitor& v, Girth& g) {
  v.choice("from", g.from, kGirths, "What the thickness of branches comes from");
  v.number("radius", g.radius, {.min = 0, .max = 100, .unit = "m"}, "At the base; 0: as the turtle has it");
  v.number("exponent", g.exponent, {.min = 1, .max = 4}, "n of the pipe model");
  v.curve("curve", g.curve, "For distance: share of the radius, from 0 at a tip to 1 at the base");
  v.number("least", g.least, {.min = 0.00001, .max = 1, .unit = "m"}, "The thinnest radius");
  v.number("flare", g.flare, {.min = 0, .max = 4}, "How much wider the foot is");
}

template <class Visitor>
void describe(Visitor& v, Bark& b) {
  v.choice("kind", b.kind, kBarks, "What it is made of");
  v.list("colors", b.colors, Count{1, 64}, "The turtle's colour index picks one, round and round");
  v.color("second", b.second, "In furrows and bands");
  v.number("scale", b.scale, {.min = 0.0005, .max = 10, .unit = "m"}, "Width of a furrow");
  v.number("depth", b.depth, {.min = 0, .max = 3}, "Of the relief");
  v.color("young", b.young, "Of shoots");
  v.number("young_length", b.young_length, {.min = 0, .max = 10, .unit = "m"},
           "Below a tip, until a shoot is wood");
  v.number("variation", b.variation, {.min = 0, .max = 0.9}, "How much single plants differ in brightness");
}

template <class Visitor>
void describe(Visitor& v, BladeLook& b) {
  v.list("colors", b.colors, Count{1, 64}, "The turtle's colour index picks one, round and round");
  v.color("second", b.second, "Of the veins");
  v.choice("tissue", b.tissue, kBladeTissues, "What they are made of");
}

template <class Visitor>
void describe(Visitor& v, Sprig& s) {
  v.integer("pairs", s.pairs, {.min = 0, .max = 60}, "Of leaves");
  v.boolean("end_leaf", s.end_leaf, "Whether one stands at the tip");
  v.angle("angle", s.angle, {.min = 5, .max = 110}, "Between leaf and stalk");
  v.number("length", s.length, {.min = 0.05, .max = 1}, "Of a leaf as a share of the sprig's");
  v.number("shrink", s.shrink, {.min = 0, .max = 0.9}, "How much smaller leaves at the tip are");
  v.number("alternate", s.alternate, {.min = 0, .max = 1}, "0: in pairs; 1: by turns");
}

template <class Visitor>
void describe(Visitor& v, LeafLook& l) {
  v.choice("shape", l.shape, kLeafShapes, "Its outline");
  v.list("outline", l.outline, Count{0, 64},
         "Of an own shape: radii from the tip to the stalk, by even angles");
  v.number("width", l.width, {.min = 0.1, .max = 4}, "Factor across");
  v.number("size", l.size, {.min = 0.001, .max = 10, .unit = "m"}, "Length, of a sprig the whole of it");
  v.boolean("sprig", l.sprig, "Sprigs in place of leaves");
  v.object("sprigs", l.sprigs, "How leaves stand on a sprig");
  v.list("colors", l.colors, Count{1, 16}, "Each leaf has one of them");
  v.color("veins", l.veins, "Of veins and stalk");
  v.color("rim", l.rim, "Toward the rim");
  v.number("spots", l.spots, {.min = 0, .max = 1}, "How much the colour varies over a leaf");
  v.angle("fold", l.fold, {.min = -80, .max = 80}, "By which each half is raised");
  v.angle("bend", l.bend, {.min = -180, .max = 180}, "From foot to tip, downward");
  v.integer("detail", l.detail, {.min = 3, .max = 80}, "Points of the mesh along half a rim");
  v.integer("pixels", l.pixels, {.min = 16, .max = 4096}, "Height of its picture");
  v.number("size_variation", l.size_variation, {.min = 0, .max = 0.9},
           "Random change of the size, as a share");
  v.angle("turn_variation", l.turn_variation, {.min = 0, .max = 180}, "Random tilt, either way");
}

template <class Visitor>
void describe(Visitor& v, BarkCoat& c) {
  v.choice("pattern", c.image.pattern, kBarkPatterns, "What it looks like");
  v.color("color", c.image.color, "On the ridges");
  v.color("second", c.image.second, "In furrows, cracks and bands");
  v.color("lichen", c.image.lichen, "Of the lichens");
  v.number("lichens", c.image.lichens, {.min = 0, .max = 1}, "How much of it they cover");
  v.integer("ridges", c.image.ridges, {.min = 1, .max = 200}, "Round the picture");
  v.number("stretch", c.image.stretch, {.min = 0.5, .max = 40}, "How much longer than wide its features are");
  v.number("warp", c.image.warp, {.min = 0, .max = 3}, "How far ridges wander");
  v.number("depth", c.image.depth, {.min = 0, .max = 1}, "Of furrows");
  v.number("wrap", c.wrap, {.min = 0.001, .max = 20, .unit = "m"}, "Round a branch that the picture is wide");
  v.number("aspect", c.aspect, {.min = 0.25, .max = 16}, "How much longer than wide the picture is");
  v.integer("pixels", c.pixels, {.min = 16, .max = 8192}, "Its width");
  v.number("relief", c.relief, {.min = 0, .max = 10}, "Of the bumps");
  v.number("facet", c.facet, {.min = 0.0005, .max = 10, .unit = "m"}, "Width of a side of the mesh, about");
  v.number("twigs", c.twigs, {.min = 0, .max = 10, .unit = "m"},
           "Branches that begin with a smaller radius wear the plain bark");
}

inline constexpr std::string_view kSeasonTimes = "winter is 0, spring 0.25, summer 0.5, autumn 0.8";

template <class Visitor>
void describe(Visitor& v, Blossom& b) {
  v.number("share", b.share, {.min = 0, .max = 1}, "Of the leaves' places that bear flowers");
  v.integer("cluster", b.cluster, {.min = 1, .max = 40}, "Flowers at one place");
  v.number("size", b.size, {.min = 0.0005, .max = 2, .unit = "m"}, "Across a flower");
  v.integer("petals", b.petals, {.min = 1, .max = 60}, "Of a flower");
  v.color("color", b.color, "Of the petals");
  v.color("heart", b.heart, "Of the heart");
  v.number("at", b.at, {.min = 0, .max = 1, .unit = "years"}, "Time of the year at which they open");
  v.number("lasts", b.lasts, {.min = 0, .max = 0.6, .unit = "years"}, "Until the petals fall");
}

template <class Visitor>
void describe(Visitor& v, Seasons& s) {
  v.shorthand("at");
  v.animated("at", s.at, {.min = -1000, .max = 1000, .unit = "years", .sense = kSeasonTimes},
             "0 new year, 0.25 spring, 0.5 midsummer, 0.8 autumn, 1.5 the next summer");
  v.number("opening", s.opening, {.min = 0, .max = 1, .unit = "years"},
           "Time of the year at which leaves unfold");
  v.number("turning", s.turning, {.min = 0, .max = 1, .unit = "years"}, "When they begin to turn");
  v.number("fall", s.fall, {.min = 0, .max = 1, .unit = "years"}, "When they fall");
  v.number("spread", s.spread, {.min = 0, .max = 0.3, .unit = "years"}, "From the first leaf to the last");
  v.number("drift", s.drift, {.min = 0.0001, .max = 0.2, .unit = "years"}, "How long a leaf is in the air");
  v.number("litter", s.litter, {.min = 0, .max = 1}, "Share of the fallen leaves that lie until spring");
  v.boolean("evergreen", s.evergreen, "Leaves stay as they are");
  v.color("young", s.young, "Of leaves that unfold");
  v.list("autumn", s.autumn, Count{1, 16}, "Colours that a leaf goes through, some to the last, some not");
  v.object("blossom", s.blossom, "Flowers where leaves stand; none where it is not given");
}

template <class Visitor>
void describe(Visitor& v, TreeDress& d) {
  v.object("bark", d.bark, "Their surface");
  v.object("coat", d.coat, "A bark as a picture; branches are meshes then");
  v.object("leaves", d.leaves, "The leaves");
  v.object("season", d.season, "Its year");
  v.object("wave", d.wave, "Swaying in the wind");
  v.object("growth", d.growth, "When it grows");
}

}  // namespace frond
