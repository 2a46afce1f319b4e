#pragma once

#include "grammar/guide.h"
#include "preset/reader.h"

// The guide of a grammar as presets spell it; see preset/describe.h.

namespace frond {

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
  v.text("file", g.file, "An OBJ file of lines, as seen from this file's folder, in place of points");
  v.number("tolerance", g.tolerance, {.min = 0, .max = 1e6}, "How near to a point counts as there");
  v.number("leniency", g.leniency, {.min = 0, .max = 10, .above_min = true},
           "A step is this share of the way to the point");
  v.boolean("reach_ends", g.reach_ends, "Whether a point without children must be come to as well");
}

}  // namespace frond
