#pragma once

#include "grammar/grammar.h"
#include "grammar/guide.h"
#include "preset/reader.h"

// The properties of grammars and their guides, as presets spell them; see preset/describe.h.

namespace frond {

inline constexpr Choice<GrammarText::Mode> kGrammarModes[] = {
    {"parallel", GrammarText::Mode::parallel, "all symbols at once"},
    {"sequential", GrammarText::Mode::sequential, "the leftmost symbol that has a rule"}};

inline constexpr Choice<Dialect> kDialects[] = {
    {"abop", Dialect::abop, "as in The Algorithmic Beauty of Plants and cpfg"},
    {"houdini", Dialect::houdini, "as in Houdini's L-system node"}};

template <class Visitor>
void describe(Visitor& v, GrammarText::Rule& r) {
  v.shorthand("rule");
  v.origin(r.where);
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

/// What lies at a guide point besides its place and its children.
template <class Visitor>
void describe(Visitor& v, GuidePoint& p) {
  v.vector("at", p.at, "Its place");
  v.required("at");
  v.number("radius", p.radius, {.min = 1e-6, .max = 1e6}, "Of the branch from here on");
  v.number("angle", p.angle, {.min = -360, .max = 360, .unit = "degrees"}, "Of bare turns from here on");
  v.number("elasticity", p.elasticity, {.min = -10, .max = 10}, "How readily branches bend from here on");
  v.vector("tropism", p.tropism, "What they turn toward from here on");
}

/// Reads the lines of a guide's file.
Errors load_guide(const NamedFile& file, GuideText& guide);

/// Reads a line of points: each is [x, y, z], or an object with what lies there and with `children`, the side
/// lines that start there. Points are appended; each hangs from the one before it in its line.
bool read_guide_line(Reader& reader, const Value& value, std::vector<GuidePoint>& points);

inline constexpr std::string_view kGuideLineSchema = R"json({
  "type": "array",
  "items": {
    "anyOf": [
      {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3},
      {
        "type": "object",
        "properties": {
          "at": {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3},
          "radius": {"type": "number"},
          "angle": {"type": "number"},
          "elasticity": {"type": "number"},
          "tropism": {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3},
          "children": {"type": "array"}
        },
        "required": ["at"],
        "additionalProperties": false
      }
    ]
  }
})json";

template <class Visitor>
void describe(Visitor& v, GuideText& g) {
  v.custom(
      "points", g.points, read_guide_line, kGuideLineSchema,
      "A line of points, each [x, y, z] or {at, radius, angle, elasticity, tropism, children}; children are "
      "points or lines of points that start there");
  v.list("parent", g.parent,
         "The number of the point before each point, -1 for none; without it each follows "
         "the one before it");
  v.list("bezier", g.bezier, "Control points of a curve of any degree, in place of points");
  v.integer("samples", g.samples, {.min = 1, .max = 100000}, "Pieces that the curve is cut into");
  v.file(
      "file", g.file, [&](const NamedFile& file) { return load_guide(file, g); },
      "An OBJ file of lines, as seen from this file's folder, in place of points");
  v.number("tolerance", g.tolerance, {.min = 0, .max = 1e6}, "How near to a point counts as there");
  v.number("leniency", g.leniency, {.min = 0, .max = 10, .above_min = true},
           "A step is this share of the way to the point");
  v.boolean("reach_ends", g.reach_ends, "Whether a point without children must be come to as well");
}

template <class Visitor>
void describe(Visitor& v, GrammarText& g) {
  v.origin(g.where);
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
  v.list("symbols", g.symbols, "Names of more than one character");
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

}  // namespace frond
