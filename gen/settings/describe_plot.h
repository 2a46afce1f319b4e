#pragma once

#include "land/plot.h"
#include "preset/reader.h"

// The properties of ponds and paths as presets spell them; see preset/describe.h.

namespace frond {

/// The hours of a day.
inline constexpr Range kHours{.min = 0, .max = 24, .unit = "h", .sense = "dawn is 6, noon 12, dusk 19"};

template <class Visitor>
void describe(Visitor& v, PondShape& p) {
  v.vector("center", p.center, {.min = -28, .max = 28, .unit = "m"}, "Middle of the pond, x and z");
  v.vector("size", p.size, {.min = 0, .max = 20, .unit = "m"},
           "Distance from the middle to the shore along x and along z; 0 is no pond");
  v.number("depth", p.depth, {.min = 0.1, .max = 5, .unit = "m"}, "Depth of the pond's bed below the lawn");
  v.number("level", p.level, {.min = -2, .max = 0, .unit = "m"},
           "Height of the water above the lawn; negative is below it");
}

template <class Visitor>
void describe(Visitor& v, PathShape& p) {
  v.list("points", p.points, "Points [x, z] in metres of a smooth curve; fewer than two make no path");
  v.number("width", p.width, {.min = 0.1, .max = 20, .unit = "m"}, "Width of the path");
}

}  // namespace frond
