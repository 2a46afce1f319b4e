#pragma once

#include "organisms/stone_look.h"
#include "preset/reader.h"
#include "rocks/rock.h"

// The properties of all that is stone, as presets spell them; see preset/describe.h.

namespace frond {

inline constexpr Choice<Falloff> kFalloffs[] = {
    {"gaussian", Falloff::gaussian, "exp(-r d^2)"},
    {"soft", Falloff::soft, "1 - 4 d^6/9r^6 + 17 d^4/9r^4 - 22 d^2/9r^2"},
    {"cubic", Falloff::cubic, "(1 - d^2/r^2)^3"}};

inline constexpr Choice<StoneKind> kStoneKinds[] = {
    {"granite", StoneKind::granite, "speckled and massive"},
    {"limestone", StoneKind::limestone, "pale, banded and pitted"},
    {"basalt", StoneKind::basalt, "dark, fine and cracked"}};

template <class Visitor>
void describe(Visitor& v, Blob& b) {
  v.vector("radius", b.radius, {.min = 0.01, .max = 100}, "Along x, y and z");
  v.vector("center", b.center, {.min = -1000, .max = 1000}, "Its middle, in radii");
}

template <class Visitor>
void describe(Visitor& v, Weathering& w) {
  v.integer("facets", w.facets, {.min = 0, .max = 100}, "Planes along which pieces have broken off");
  v.number("facet_depth", w.facet_depth, {.min = 0, .max = 0.9}, "How much has broken off");
  v.number("edge", w.edge, {.min = 0, .max = 1}, "How round the edges between facets are");
  v.number("roughness", w.roughness, {.min = 0, .max = 1}, "Lumps, dents and grain");
  v.number("strata", w.strata, {.min = 0, .max = 1}, "How far soft layers lie back behind hard ones");
  v.number("layer", w.layer, {.min = 0.01, .max = 1}, "Thickness of a layer, as a share of the size");
  v.angle("dip", w.dip, {.min = 0, .max = 90}, "Of the layers from the horizontal");
  v.number("underside", w.underside, {.min = 0, .max = 0.9},
           "Share of the height below which it is cut flat");
}

template <class Visitor>
void describe(Visitor& v, StoneLook& s) {
  v.choice("kind", s.kind, kStoneKinds, "What it is");
  v.color("color", s.color, "Of the stone; that of its kind where not given");
  v.color("second", s.second, "Of what differs in it; that of its kind where not given");
  v.number("scale", s.scale, {.min = 0.001, .max = 100, .unit = "m"}, "Size of the pattern");
  v.number("relief", s.relief, {.min = 0, .max = 3}, "Depth of grain and cracks");
  v.number("moss", s.moss, {.min = 0, .max = 1}, "Moss on what faces upward, and lichen");
  v.number("variation", s.variation, {.min = 0, .max = 0.9}, "How much single ones differ in brightness");
}

/// All of a shape but its size.
template <class Visitor>
void describe_shape(Visitor& v, RockShape& s) {
  v.list("ellipsoids", s.own, "The blobs that it is made of; none: random ones");
  v.integer("blobs", s.chance.count, {.min = 1, .max = 200}, "How many random ones");
  v.number("least_radius", s.chance.least_radius, {.min = 0.01, .max = 100},
           "Of a random one, along each axis");
  v.number("most_radius", s.chance.most_radius, {.min = 0.01, .max = 100},
           "Of a random one, along each axis");
  v.choice("field", s.falloff, kFalloffs,
           "How the field of a blob falls with the distance d from its middle");
  v.number("level", s.level, {.min = 0.01, .max = 100}, "Of the summed fields at the surface");
  v.integer("depth", s.cells.depth, {.min = 3, .max = 8}, "Of the octree: the finest cells are 1/2^depth");
  v.number("tolerance", s.cells.tolerance, {.min = 0, .max = 0.1},
           "Share of the size that flat places may be off; 0: the finest cells all over");
  v.boolean("lying", s.lying, "Its shortest side is the upright one");
  v.object("weathering", s.weathering, "What time has done to it");
}

}  // namespace frond
