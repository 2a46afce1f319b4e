#pragma once

#include "organisms/organism.h"
#include "organisms/sowing.h"
#include "preset/reader.h"

// The properties of all organisms, as presets spell them; see preset/describe.h.

namespace frond {

inline constexpr Choice<Layer> kLayers[] = {{"canopy", Layer::canopy, "trees"},
                                            {"shrubs", Layer::shrubs, "bushes and young trees"},
                                            {"herbs", Layer::herbs, "ferns, grass, stones"}};

template <class Visitor>
void describe(Visitor& v, SowRules& s) {
  v.choice("layer", s.layer, kLayers, "Crowns of one layer keep apart, those of others may overlap");
  v.number("radius", s.radius, {.min = 0, .max = 100, .above_min = true, .unit = "m"}, "Of a crown");
  v.number("stem", s.stem, {.min = 0, .max = 50, .unit = "m"}, "That plants of other layers keep free");
  v.vector("altitude", s.altitude, {.min = -1e5, .max = 1e5, .unit = "m"},
           "Lowest and highest, above the lowest of the land");
  v.angle("slope", s.slope, {.min = 0, .max = 90}, "Steepest");
  v.number("patch", s.patch, {.min = 0, .max = 10000, .unit = "m"}, "From clump to clump; 0: evenly");
  v.number("cover", s.cover, {.min = 0, .max = 1}, "Share of the land that its clumps cover");
  v.vector("shade", s.shade, {.min = 0, .max = 1}, "Least and most share of the sky that crowns above hide");
  v.number("clear", s.clear, {.min = -100, .max = 1000, .unit = "m"},
           "That it keeps from the edge of a path");
  v.vector("center", s.center, {.min = -1e4, .max = 1e4, .unit = "m"}, "x, z of its place");
  v.number("reach", s.reach, {.min = 0, .max = 1e4, .unit = "m"}, "Round that; 0: all of the land");
  v.file(
      "map", s.map, [&](const NamedFile& file) { return load_density(file, s); },
      "A PNG whose brightness is the density, as seen from the preset's folder");
}

template <class Visitor>
void describe(Visitor& v, CopyTint& t) {
  v.angle("hue", t.hue, {.min = 0, .max = 180}, "By how much copies differ, either way");
  v.number("saturation", t.saturation, {.min = 0, .max = 1}, "Share by which copies differ");
  v.number("value", t.value, {.min = 0, .max = 1}, "Share by which copies differ in brightness");
}

template <class Visitor>
void describe(Visitor& v, Sowing& s) {
  v.integer("models", s.models, {.min = 1, .max = 64}, "That are grown, each by a seed of its own");
  v.list("seeds", s.seeds, "Seeds of the models; where none is given, a model has its number");
  v.number("crowd", s.crowd, {.min = 0, .max = 100, .unit = "m"},
           "Trees grow up among neighbours so far away; 0: in the open");
  v.object("where", s.where, "Where copies come up");
  v.object("tint", s.tint, "How their colours differ");
  v.number("upright", s.upright, {.min = 0, .max = 1}, "1 plumb, 0 across the slope");
}

inline constexpr Choice<Build> kBuilds[] = {
    {"sweeps", Build::sweeps, "each branch by itself"},
    {"fused", Build::fused, "branches grown into one body, rounded at the forks"},
    {"voxels", Build::voxels, "built of cubes"}};

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

}  // namespace frond
