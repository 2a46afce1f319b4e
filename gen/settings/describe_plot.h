#pragma once

#include "land/plot.h"
#include "preset/reader.h"

// The properties of ponds and paths as presets spell them; see preset/describe.h.

namespace frond {

/// The hours of a day.
inline constexpr Range kHours{.min = 0, .max = 24, .unit = "h", .sense = "dawn is 6, noon 12, dusk 19"};

template <class Visitor>
void describe(Visitor& v, PondShape& p) {
  v.vector("center", p.center, {.min = -28, .max = 28, .unit = "m"}, "x, z of its middle");
  v.vector("size", p.size, {.min = 0, .max = 20, .unit = "m"},
           "From the middle to the shore along x and z; 0: none");
  v.number("depth", p.depth, {.min = 0.1, .max = 5, .unit = "m"}, "Of the bed below the lawn");
  v.number("level", p.level, {.min = -2, .max = 0, .unit = "m"}, "Of the water, above the lawn");
}

template <class Visitor>
void describe(Visitor& v, PathShape& p) {
  v.list("points", p.points, "x, z in metres of a smooth curve; fewer than two: no path");
  v.number("width", p.width, {.min = 0.1, .max = 20, .unit = "m"}, "From edge to edge");
}

}  // namespace frond
