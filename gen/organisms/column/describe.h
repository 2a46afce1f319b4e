#pragma once

#include "organisms/column/column.h"
#include "preset/reader.h"

// The properties of columns, as presets spell them; see preset/describe.h.

namespace frond {

template <class Visitor>
void describe(Visitor& v, ColumnParams& c) {
  ColumnShape& s = c.shape;
  v.number("height", s.height, {.min = 0.2, .max = 30, .unit = "m"}, "With base and capital");
  v.number("radius", s.radius, {.min = 0.02, .max = 3, .unit = "m"}, "Of the shaft at its foot");
  v.number("taper", s.taper, {.min = 0.4, .max = 1}, "Radius at the top of the shaft, as a share");
  v.number("entasis", s.entasis, {.min = 0, .max = 0.2}, "How much the shaft swells, as a share");
  v.integer("flutes", s.flutes, {.min = 0, .max = 48}, "Hollows round the shaft; 0: it is plain");
  v.number("flute_depth", s.flute_depth, {.min = 0, .max = 1}, "Of a half circle");
  v.number("broken", s.broken, {.min = 0, .max = 0.95}, "Share of its height that has broken off");
  v.color("stone", c.stone, "Of the limestone");
  v.number("weathering", c.weathering, {.min = 0, .max = 1}, "Soot, damp and moss");
}

}  // namespace frond
