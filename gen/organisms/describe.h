#pragma once

#include "organisms/describe_crown.h"
#include "organisms/describe_garden.h"
#include "organisms/describe_guide.h"
#include "organisms/describe_host.h"
#include "organisms/describe_ivy.h"
#include "organisms/describe_plant.h"
#include "organisms/describe_rock.h"
#include "organisms/describe_sowing.h"
#include "organisms/describe_tree.h"
#include "organisms/organism.h"
#include "preset/reader.h"

// The properties of organisms as presets spell them; see preset/describe.h.

namespace frond {

inline constexpr Choice<SkinKind> kSkinKinds[] = {
    {"stony", SkinKind::stony, "raised cups with a pit in each, as on stony corals"},
    {"fan", SkinKind::fan, "fine and matt, as on sea fans and whips"},
    {"soft", SkinKind::soft, "furry with open polyps, as on soft corals"}};

inline constexpr Choice<Build> kBuilds[] = {
    {"sweeps", Build::sweeps, "each branch by itself"},
    {"fused", Build::fused, "branches grown into one body, rounded at the forks"},
    {"voxels", Build::voxels, "built of cubes"}};

inline constexpr Choice<CoralForm> kCoralForms[] = {
    {"branching", CoralForm::branching, "A -> !\"[B]////[B]////B, B -> &FFFA"},
    {"tufted", CoralForm::tufted, "A -> \"[&FFFA]////[&FFFA]////[&FFFA]"},
    {"own", CoralForm::own, "the rules under grammar"}};

inline constexpr Choice<GrammarText::Mode> kGrammarModes[] = {
    {"parallel", GrammarText::Mode::parallel, "all symbols at once"},
    {"sequential", GrammarText::Mode::sequential, "the leftmost symbol that has a rule"}};

inline constexpr Choice<Dialect> kDialects[] = {
    {"abop", Dialect::abop, "as in The Algorithmic Beauty of Plants and cpfg"},
    {"houdini", Dialect::houdini, "as in Houdini's L-system node"}};

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
void describe(Visitor& v, Thickness& t) {
  v.number("radius", t.radius, {.min = 0, .max = 5, .above_min = true, .unit = "m"}, "At the base");
  v.curve("curve", t.curve, "Share of the radius, from 0 at the farthest tip to 1 at the base");
  v.number("knob", t.knob, {.min = 0.1, .max = 4}, "Factor right at each tip");
  v.number("flare", t.flare, {.min = 0, .max = 4}, "How much wider the foot is");
}

template <class Visitor>
void describe(Visitor& v, Distortion& d) {
  v.number("strength", d.strength, {.min = 0, .max = 10, .unit = "m"}, "How far noise bends the tips");
  v.number("scale", d.scale, {.min = 0, .max = 100, .above_min = true, .unit = "m"}, "From bend to bend");
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
void describe(Visitor& v, Skin& s) {
  v.choice("kind", s.kind, kSkinKinds, "What it is made of");
  v.object("pores", s.pores, "Pores");
  v.object("tint", s.tint, "Colours");
}

template <class Visitor>
void describe(Visitor& v, GrammarText::Rule& r) {
  v.shorthand("rule");
  v.text("rule", r.text, "left < predecessor(parameters) > right : condition ->(weight) successor");
  v.required("rule");
  v.integer("limit", r.limit, {.min = 0, .max = 1e9}, "How often it may be used at all");
}

/// A grammar's tropism as presets group it.
struct Tropism {
  DVec3 vector;
  double elasticity;
};

template <class Visitor>
void describe(Visitor& v, Tropism& t) {
  v.direction("vector", t.vector, "The direction that branches turn toward; a longer one pulls more");
  v.number("elasticity", t.elasticity, {.min = -10, .max = 10}, "How readily they do");
}

/// Where a grammar's turtle starts, as presets group it.
struct TurtleStart {
  DVec3 position, heading;
};

template <class Visitor>
void describe(Visitor& v, TurtleStart& s) {
  v.vector("position", s.position, "Its place");
  v.direction("heading", s.heading, "Where it looks");
}

template <class Visitor>
void describe(Visitor& v, Limits& l) {
  v.integer("modules", l.modules, {.min = 1, .max = 1e12}, "Symbols of a word");
  v.integer("bytes", l.bytes, {.min = 1, .max = 1e15}, "Memory of a word");
}

template <class Visitor>
void describe(Visitor& v, GrammarText& g) {
  v.text("axiom", g.axiom, "The word to begin with");
  v.integer("steps", g.steps, {.min = 0, .max = 1e6}, "Derivation steps");
  v.number("angle", g.angle, {.min = -360, .max = 360, .unit = "degrees"}, "Of a turn that gives none");
  v.number("length", g.length, {.min = -1e6, .max = 1e6}, "Of an F that gives none");
  v.number("width", g.width, {.min = 0, .max = 1e6}, "Diameter to begin with");
  v.number("width_scale", g.width_scale, {.min = 0, .max = 100}, "What ! multiplies the width by");
  v.number("length_scale", g.length_scale, {.min = 0, .max = 100}, "What \" multiplies lengths by");
  v.number("angle_jitter", g.angle_jitter, {.min = 0, .max = 180, .unit = "degrees"},
           "Random change of each turn, either way");
  v.number("length_jitter", g.length_jitter, {.min = 0, .max = 1},
           "Random change of each length, either way, as a share");
  v.pairs("constants", g.constants, "Names for numbers and expressions");
  v.list("rules", g.rules, "Productions, tried in this order");
  v.list("decomposition", g.decomposition, "Rules that take symbols apart after each step");
  v.list("interpretation", g.interpretation, "Rules that only the turtle sees");
  v.integer("interpretation_depth", g.interpretation_depth, {.min = 0, .max = 1000},
            "How deep they are applied");
  v.choice("mode", g.mode, kGrammarModes, "Which symbols a step rewrites");
  v.choice("dialect", g.dialect, kDialects, "Whose meaning of the symbols counts");
  v.text("ignore", g.ignore, "Symbols that contexts pass over");
  v.text("consider", g.consider, "The only symbols that contexts see");
  v.integer("seed", g.seed, {.min = 0, .max = 9e15}, "For random choices");
  v.object("limits", g.limits, "What passes them is refused before it is derived");
  v.texts("symbols", g.symbols, "Names of more than one character");
  v.boolean("ring", g.ring, "The word is a circle");
  Tropism tropism{g.tropism, g.elasticity};
  v.object("tropism", tropism, "What branches turn toward as they grow");
  g.tropism = tropism.vector;
  g.elasticity = tropism.elasticity;
  TurtleStart start{g.start, g.start_heading};
  v.object("start", start, "Where the turtle starts");
  g.start = start.position;
  g.start_heading = start.heading;
  v.object("guide", g.guide, "Places that ? leads the turtle to");
}

template <class Visitor>
void describe(Visitor& v, CoralParams& c) {
  v.choice("form", c.form, kCoralForms, "The rules that it grows by");
  v.integer("steps", c.steps, {.min = 1, .max = 12},
            "How often it forks (own rules have steps of their own)");
  v.angle("pitch", c.pitch, {.min = -180, .max = 180}, "Of a new branch, &");
  v.angle("roll", c.roll, {.min = -180, .max = 180}, "Of one of the four / between branches");
  v.angle("angle_jitter", c.angle_jitter, {.min = 0, .max = 90}, "Random change of each turn, either way");
  v.number("length_jitter", c.length_jitter, {.min = 0, .max = 0.95},
           "Random change of each internode, as a share of it");
  v.number("internode", c.internode, {.min = 0.0001, .max = 100, .unit = "m"}, "What one F draws");
  v.number("length_scale", c.length_scale, {.min = 0.2, .max = 3}, "What \" multiplies lengths by");
  v.number("width_scale", c.width_scale, {.min = 0.2, .max = 2}, "What ! multiplies thickness by");
  v.number("lift", c.lift, {.min = -1, .max = 1}, "How much each internode turns upward");
  v.number("height", c.height, {.min = 0, .max = 1000, .unit = "m"},
           "What the whole is scaled to; 0: as it grows");
  v.integer("smoothing", c.smoothing, {.min = 1, .max = 16}, "Nodes for each internode");
  v.object("grammar", c.grammar, "Rules of your own, for the form own");
  v.object("thickness", c.thickness, "Thickness along the branches");
  v.object("distortion", c.distortion, "Noise that bends the shape");
  v.object("skin", c.skin, "Pores and colours");
  v.object("wave", c.wave, "Swaying in the current");
  v.object("food", c.food, "What the branches bend toward");
  v.object("growth", c.growth, "When it grows");
}

template <class Visitor>
void describe(Visitor& v, Place& p) {
  v.list("at", p.at,
         "x, z of the first ones, within 30 m of the middle or on the land of a forest; the others are "
         "scattered");
  v.vector("center", p.center, {.min = -28, .max = 28, .unit = "m"}, "x, z of the ring to scatter in");
  v.number("inner", p.inner, {.min = 0, .max = 28, .unit = "m"}, "Inner edge of the ring");
  v.number("radius", p.radius, {.min = 0, .max = 28, .unit = "m"}, "Outer edge of the ring");
  v.number("spacing", p.spacing, {.min = 0, .max = 100, .unit = "m"}, "What each keeps free round itself");
  v.number("size_variation", p.size_variation, {.min = 0, .max = 0.9}, "Random change of the size");
  v.angle("turn", p.turn, {.min = -360, .max = 360}, "About the vertical");
  v.angle("turn_variation", p.turn_variation, {.min = 0, .max = 180},
          "Random change of the turn, either way");
  v.angle("lean", p.lean, {.min = 0, .max = 90}, "Up to how far each leans");
  v.number("raise", p.raise, {.min = -100, .max = 1000, .unit = "m"}, "Above the ground");
  v.number("rock", p.rock, {.min = 0, .max = 100, .unit = "m"}, "Width of the rock under each; 0: none");
}

template <class Visitor>
void describe(Visitor& v, Style& s) {
  v.shorthand("build");
  v.choice("build", s.build, kBuilds, "What branches are drawn as");
  v.number("voxel", s.voxel, {.min = 0, .max = 100, .unit = "m"},
           "Side of a voxel, or of a cube; 0: by the size of the organism");
  v.number("blend", s.blend, {.min = 0, .max = 3},
           "How far branches flow into each other at forks, as a share of the thinner one's radius");
  v.number("adaptivity", s.adaptivity, {.min = 0, .max = 1},
           "Of fused ones: 0 equal triangles, 1 few where the body is flat");
  v.number("limit", s.limit, {.min = 1e6, .max = 1e15, .unit = "bytes"},
           "Memory; a volume that is foreseen to need more is refused");
}

template <class Visitor>
void describe(Visitor& v, Organism& o) {
  v.text("name", o.name, "Your name for it");
  v.integer("count", o.count, {.min = 0, .max = 1000000}, "How many, those at given places included");
  v.object("place", o.place, "Where they stand");
  v.object("sown", o.sown, "Copies of a few models, sown over the land");
  v.object("body", o.style, "What their branches are drawn as");
}

/// The table of growers: one row a kind.
inline constexpr Kind<Organism> kOrganismKinds[] = {
    make_kind<CoralParams, &Organism::body>("coral", "A branching coral from an L-system"),
    make_kind<PlantParams, &Organism::body>("plant", "Anything that an L-system draws: herbs, trees, curves"),
    make_kind<RockParams, &Organism::body>("rock", "A rock: blobs, weathered"),
    make_kind<PebblesParams, &Organism::body>("pebbles", "Many small rocks that lie about"),
    make_kind<WallParams, &Organism::body>("wall", "A wall of bricks with windows and doors, or its ruin"),
    make_kind<ColumnParams, &Organism::body>("column", "A column of stone, whole or broken"),
    make_kind<MeshParams, &Organism::body>("mesh", "A body from an OBJ file"),
    make_kind<BridgeParams, &Organism::body>("bridge", "A humped garden bridge of wood or stone"),
    make_kind<VaseParams, &Organism::body>("vase", "A vase, bowl or pot turned from a Bézier curve"),
    make_kind<WeberPennParams, &Organism::body>("weber_penn", "A tree by the parameters of Weber and Penn"),
    make_kind<ColonizedParams, &Organism::body>("colonized", "A tree that fills an envelope"),
    make_kind<TreeParams, &Organism::body>("tree",
                                           "A tree that fights for light; all of a scene grow together"),
    make_kind<IvyParams, &Organism::body>("ivy", "Ivy that creeps over other bodies")};

}  // namespace frond
