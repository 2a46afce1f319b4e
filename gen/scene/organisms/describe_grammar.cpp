#include "organisms/describe_grammar.h"

#include "core/assets.h"
#include "geometry/obj.h"
#include "grammar/import.h"
#include "grammar/kind.h"
#include "preset/keys.h"
#include "preset/reader.h"

namespace frond {

namespace {

constexpr Choice<GrammarText::Mode> kGrammarModes[] = {
    {"parallel", GrammarText::Mode::parallel, "all symbols at once"},
    {"sequential", GrammarText::Mode::sequential, "the leftmost symbol that has a rule"}};

constexpr Choice<Dialect> kDialects[] = {
    {"abop", Dialect::abop, "as in The Algorithmic Beauty of Plants and cpfg"},
    {"houdini", Dialect::houdini, "as in Houdini's L-system node"},
    {"lparser", Dialect::lparser,
     "as in LParser: rolls are < and >, widths are shares of a segment's length, and a parameter stays "
     "behind what its letter becomes"}};

}  // namespace

void describe(Properties& v, GrammarText::Rule& r) {
  v.shorthand("rule");
  v.origin(r.where);
  v.text("rule", r.text,
         "The rule itself: left < predecessor(parameters) > right : condition ->(weight) successor");
  v.required("rule");
  v.integer("limit", r.limit, {.min = 0, .max = 1e9},
            "How often the rule may be used in the whole derivation");
}

/// A grammar's tropism as presets group it.
struct Tropism {
  DVec3 vector;
  double elasticity;
};

void describe(Properties& v, Tropism& t) {
  v.direction("vector", t.vector,
              "Direction that branches turn toward as they are drawn; a longer vector pulls more");
  v.number("elasticity", t.elasticity, {.min = -10, .max = 10},
           "How readily branches turn toward the vector; 0 not at all, negative turns them away");
}

/// Where a grammar's turtle starts, as presets group it.
struct TurtleStart {
  DVec3 position, heading;
};

void describe(Properties& v, TurtleStart& s) {
  v.vector("position", s.position, "Where the turtle starts");
  v.direction("heading", s.heading, "Direction in which the turtle looks at the start");
}

void describe(Properties& v, Limits& l) {
  v.integer("modules", l.modules, {.min = 1, .max = 1e12}, "Greatest number of symbols in a word");
  v.integer("bytes", l.bytes, {.min = 1, .max = 1e15}, "Greatest memory for a word");
}

void describe(Properties& v, GuidePoint& p) {
  v.vector("at", p.at, "Where the point is");
  v.required("at");
  v.vector("in", p.in,
           "Handle on the side that the line comes from, from the point; not given: opposite to out");
  v.vector("out", p.out,
           "Handle on the side that the line goes on to, from the point; not given: opposite to in");
  v.number("radius", p.radius, {.min = 1e-6, .max = 1e6}, "Radius of the branch from this point on");
  v.number("angle", p.angle, {.min = -360, .max = 360, .unit = "degrees"},
           "Angle of turns without a parameter from this point on");
  v.number("elasticity", p.elasticity, {.min = -10, .max = 10},
           "How readily branches bend from this point on");
  v.vector("tropism", p.tropism, "Direction that branches turn toward from this point on");
}

void describe_rest(KeyWriter& v, GuidePoint& p) { v.add("parent", p.parent); }

namespace {

/// What hangs from a point.
struct Children {
  const Value* list = nullptr;
};
void describe_rest(KeyWriter&, Children&) {}

/// An object of a point, its children kept apart.
struct PointObject {
  GuidePoint point;
  Children children;
};

void describe(Properties& v, PointObject& object) {
  describe(v, object.point);
  v.custom(
      "children", object.children,
      [](Reader& reader, const Value& value, Children& children) {
        if (!value.is(Value::Type::list)) return reader.fault(value, "a list of points"), false;
        children.list = &value;
        return true;
      },
      "", "");
}

bool is_list_of_lists(const Value& value) {
  return value.is(Value::Type::list) && !value.items.empty() && !value.items[0].is(Value::Type::number);
}

bool read_line(Reader& reader, const Value& value, std::int32_t parent, std::vector<GuidePoint>& points);

/// One point and what hangs from it. Its number in `index`.
bool read_point(Reader& reader, const Value& value, std::int32_t parent, std::vector<GuidePoint>& points,
                std::int32_t& index) {
  PointObject read;
  bool good = true;
  if (value.is(Value::Type::object)) {
    good = reader.object_at(value, read);
  } else {
    std::optional<DVec3> at = reader.vector_at<DVec3>(value, {});
    good = at.has_value();
    if (at) read.point.at = *at;
  }
  read.point.parent = parent;
  index = static_cast<std::int32_t>(points.size());
  points.push_back(read.point);
  if (!read.children.list) return good;
  reader.inside("children", [&] {
    for (std::size_t i = 0; i < read.children.list->items.size(); ++i) {
      const Value& item = read.children.list->items[i];
      std::int32_t ignored = 0;
      good &= reader.inside(std::to_string(i), [&] {
        return is_list_of_lists(item) ? read_line(reader, item, index, points)
                                      : read_point(reader, item, index, points, ignored);
      });
    }
  });
  return good;
}

bool read_line(Reader& reader, const Value& value, std::int32_t parent, std::vector<GuidePoint>& points) {
  if (!value.is(Value::Type::list)) return reader.fault(value, "a list of points"), false;
  bool good = true;
  for (std::size_t i = 0; i < value.items.size(); ++i) {
    good &= reader.inside(std::to_string(i),
                          [&] { return read_point(reader, value.items[i], parent, points, parent); });
  }
  return good;
}

}  // namespace

bool read_guide_line(Reader& reader, const Value& value, std::vector<GuidePoint>& points) {
  return read_line(reader, value, GuidePoint::kRoot, points);
}

Result<GuideLines> read_guide_file(const NamedFile& file) {
  std::string name = file.path.string();
  if (grammar_kind(name, file.text) == GrammarKind::skeleton) {
    Result<GuideLines> lines = skeleton_lines(file.text);
    // What stands in a file that a preset names is not shown.
    if (!lines) return Error{name, "is a skeleton that cannot be read; `frond derive` of it says why"};
    return lines;
  }
  Result<LineSet> lines = read_obj_lines(file.text, name);
  if (!lines) return lines.errors();
  return GuideLines{std::move(lines->place), std::move(lines->line)};
}

const std::string_view kGuideLineSchema = R"json({
  "type": "array",
  "items": {
    "anyOf": [
      {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3},
      {
        "type": "object",
        "properties": {
          "at": {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3,
                 "description": "Where the point is"},
          "in": {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3,
                 "description": "Handle on the side that the line comes from, from the point; not given: opposite to out"},
          "out": {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3,
                  "description": "Handle on the side that the line goes on to, from the point; not given: opposite to in"},
          "radius": {"type": "number", "description": "Radius of the branch from this point on"},
          "angle": {"type": "number", "description": "Angle of turns without a parameter from this point on, degrees"},
          "elasticity": {"type": "number", "description": "How readily branches bend from this point on"},
          "tropism": {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3,
                      "description": "Direction that branches turn toward from this point on"},
          "children": {"type": "array", "description": "Points or lines of points that start at this one"}
        },
        "required": ["at"],
        "additionalProperties": false
      }
    ]
  }
})json";

void describe_line(Properties& v, GuideText& g) {
  v.list("bezier", g.bezier, "Control points of a Bézier curve of any degree, in place of points");
  v.integer("samples", g.samples, {.min = 1, .max = 100000},
            "Number of pieces that the Bézier curve is cut into");
  v.file(
      "file", g.file,
      [&](const NamedFile& file) -> Errors {
        Result<GuideLines> lines = read_guide_file(file);
        if (!lines) return lines.errors();
        g.lines = std::move(*lines);
        return {};
      },
      "An OBJ file of lines or a skeleton as SWC, named as seen from this file's folder, in place of points");
}

void describe(Properties& v, GuideText& g) {
  v.custom(
      "points", g.points, read_guide_line, kGuideLineSchema,
      "A line of points, each [x, y, z] or {at, in, out, radius, angle, elasticity, tropism, children}; "
      "in and out are handles of Bézier curves, children are points or lines of points that start there");
  v.list("parent", g.parent,
         "Number of the point that comes before each point, -1 for none; without it each follows the one "
         "before it");
  describe_line(v, g);
  v.number("tolerance", g.tolerance, {.min = 0, .max = 1e6},
           "Distance to a point at which it counts as reached");
  v.number("leniency", g.leniency, {.min = 0, .max = 10, .above_min = true},
           "Length of a step toward a point, as a share of the way to it");
  v.boolean("reach_ends", g.reach_ends, "Whether points without children must be reached as well");
}

void describe_grammar(Properties& v, GrammarText& g, LoadFile load, std::string_view doc) {
  v.origin(g.where);
  v.file("file", g.file, load, doc);
  v.text("axiom", g.axiom, "The word that the derivation begins with");
  v.integer("steps", g.steps, {.min = 0, .max = 1e6}, "Number of derivation steps");
  v.number("last_step", g.last_step, kShare, "How far the last step has grown");
  v.number("angle", g.angle, {.min = -360, .max = 360, .unit = "degrees"}, "Angle of a turn that gives none");
  v.number("length", g.length, {.min = -1e6, .max = 1e6}, "Length of an F or f that gives none");
  v.number("width", g.width, {.min = 0, .max = 1e6}, "Diameter that the turtle begins with");
  v.number("width_scale", g.width_scale, {.min = 0, .max = 100}, "Factor by which ! multiplies the diameter");
  v.number("length_scale", g.length_scale, {.min = 0, .max = 100}, "Factor by which \" multiplies lengths");
  v.number("angle_scale", g.angle_scale, {.min = 0, .max = 100},
           "Factor by which symbols of Houdini and LParser multiply or divide the angle");
  v.number("angle_jitter", g.angle_jitter, {.min = 0, .max = 180, .unit = "degrees"},
           "Random change of each turn, either way");
  v.number("length_jitter", g.length_jitter, kShare,
           "Random change of each length, either way, as a share of it");
  v.pairs("constants", g.constants, "Names for numbers and expressions that rules may use");
  v.list("rules", g.rules, "The productions, tried in this order");
  v.list("decomposition", g.decomposition, "Rules that take symbols apart after each step");
  v.list("interpretation", g.interpretation,
         "Rules that replace symbols for the turtle alone, when the last step is done");
  v.integer("interpretation_depth", g.interpretation_depth, {.min = 0, .max = 1000},
            "How many times over interpretation rules are applied to what they give");
  v.choice("mode", g.mode, kGrammarModes, "Which symbols one step rewrites");
  v.choice("dialect", g.dialect, kDialects, "Whose meaning of the symbols counts");
  v.integer("mutate", g.mutations, {.min = 0, .max = 10000},
            "How often the rules are changed by chance, as LParser does it; for rules of its dialect");
  v.text("ignore", g.ignore, "Symbols that contexts pass over");
  v.text("consider", g.consider, "The only symbols that contexts see");
  v.integer("seed", g.seed, {.min = 0, .max = 9e15}, "Seed of the grammar's random choices");
  v.object("limits", g.limits, "Limits of the word; what would pass them is refused before it is derived");
  v.list("symbols", g.symbols, "Names of symbols with more than one character");
  v.boolean("ring", g.ring, "Whether the word is a circle, its end followed by its beginning");
  Tropism tropism{g.tropism, g.elasticity};
  v.object("tropism", tropism, "What branches turn toward as they grow");
  g.tropism = tropism.vector;
  g.elasticity = tropism.elasticity;
  TurtleStart start{g.start, g.start_heading};
  v.object("start", start, "Where and how the turtle starts");
  g.start = start.position;
  g.start_heading = start.heading;
  v.object("guide", g.guide, "Places that the symbol ? leads the turtle to");
}

void describe(Properties& v, GrammarText& g) {
  describe_grammar(
      v, g, [&](const NamedFile& file) { return load_grammar(file, g); },
      "A grammar of LParser, Houdini or Fractint or a skeleton as SWC, named as seen from this file's "
      "folder; what else is given here counts in place of what stands there");
}

}  // namespace frond
