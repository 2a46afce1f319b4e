#pragma once

#include "organisms/describe_stone.h"
#include "organisms/pebbles/pebbles.h"

// The properties of pebbles, as presets spell them; see preset/describe.h.

namespace frond {

template <class Visitor>
void describe(Visitor& v, PebblesParams& p) {
  describe_shape(v, p.shape);
  v.object("stone", p.stone, "Their surface");
  v.integer("shapes", p.shapes, {.min = 1, .max = 1000}, "How many different ones");
  v.integer("number", p.number, {.min = 1, .max = 20000}, "How many lie there, if there is room");
  v.number("radius", p.radius, {.min = 0.01, .max = 100, .unit = "m"}, "Of the field");
  v.number("inner", p.inner, {.min = 0, .max = 100, .unit = "m"}, "What stays free round its middle");
  v.number("least_size", p.least_size, {.min = 0.001, .max = 100, .unit = "m"},
           "Longest side of the smallest");
  v.number("most_size", p.most_size, {.min = 0.001, .max = 100, .unit = "m"}, "Longest side of the largest");
  v.number("buried", p.buried, {.min = 0, .max = 1}, "Share of the height that is in the ground");
}

}  // namespace frond
