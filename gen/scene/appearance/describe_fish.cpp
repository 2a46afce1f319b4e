#include "appearance/describe_fish.h"

namespace frond {

namespace {

constexpr Choice<TailShape> kTailShapes[] = {{"forked", TailShape::forked, "two lobes"},
                                             {"lunate", TailShape::lunate, "a crescent"},
                                             {"round", TailShape::round, "a fan"},
                                             {"square", TailShape::square, "cut straight"}};
inline constexpr Choice<FishPattern> kFishPatterns[] = {
    {"plain", FishPattern::plain, "dark above and pale below"},
    {"bars", FishPattern::bars, "bars from back to belly"},
    {"lines", FishPattern::lines, "lines from head to tail"}};

}  // namespace

void describe(Properties& v, FishForm& f) {
  v.number("depth", f.depth, {.min = 0.05, .max = 0.9}, "Depth of the body, as a share of the length");
  v.number("width", f.width, {.min = 0.05, .max = 1.2}, "Width of the body, as a share of its depth");
  v.number("deepest", f.deepest, {.min = 0.15, .max = 0.7},
           "Where the body is deepest, as a share of it from the nose");
  v.number("snout", f.snout, {.min = 0, .max = 1.5}, "How far the head is drawn out: 0 blunt, 1 a beak");
  v.number("peduncle", f.peduncle, {.min = 0.05, .max = 0.8},
           "Depth of the body before the tail, as a share of the greatest depth");
  v.choice("tail", f.tail, kTailShapes, "Shape of the tail");
  v.number("tail_depth", f.tail_depth, {.min = 0.02, .max = 1},
           "Depth of the tail, as a share of the length");
  v.number("dorsal", f.dorsal, {.min = 0, .max = 0.5},
           "Height of the fin on the back, as a share of the length");
  v.number("dorsal_from", f.dorsal_from, {.min = 0.1, .max = 0.7},
           "Where that fin begins, as a share of the length");
  v.number("anal", f.anal, {.min = 0, .max = 0.5}, "Height of the fin below, as a share of the length");
  v.number("pectoral", f.pectoral, {.min = 0, .max = 0.5},
           "Length of the fins at the sides, as a share of the length");
}

void describe(Properties& v, FishLook& l) {
  v.aspect(Aspect::look);
  v.color("back", l.back, "Colour of the back");
  v.color("flank", l.flank, "Colour of the sides");
  v.color("belly", l.belly, "Colour of the belly");
  v.color("fins", l.fins, "Colour of the fins");
  v.color("tail", l.tail, "Colour of the tail");
  v.number("tail_from", l.tail_from, {.min = 0, .max = 1},
           "Where the colour of the tail begins, as a share of the length");
  v.choice("pattern", l.pattern, kFishPatterns, "What is drawn on the sides");
  v.color("mark", l.mark, "Colour of bars or lines");
  v.color("edge", l.edge, "Colour of their edges");
  v.number("edging", l.edging, {.min = 0, .max = 2}, "Width of the edges, as a share of half a mark's width");
  v.integer("marks", l.marks, {.min = 1, .max = 20}, "Number of bars or lines");
  v.number("mark_width", l.mark_width, {.min = 0.002, .max = 0.5}, "Width of each, as a share of the length");
  v.number(
      "mark_from", l.mark_from, {.min = 0, .max = 1},
      "Where the first is: of bars as a share of the length, of lines as a share of the depth from below");
  v.number("mark_to", l.mark_to, {.min = 0, .max = 1}, "Where the last is");
  v.boolean("marked_fins", l.marked_fins, "Whether bars go on over the fins");
  v.color("iris", l.iris, "Colour of the eye round its pupil");
  v.number("eye", l.eye, {.min = 0, .max = 0.2}, "Width of the eye, as a share of the length");
  v.number("scales", l.scales, {.min = 0, .max = 1}, "How much scales show");
  v.number("gloss", l.gloss, {.min = 0, .max = 1}, "How much the fish shine");
  v.integer("pixels", l.pixels, {.min = 32, .max = 2048}, "Width of the picture that they are painted with");
}

}  // namespace frond
