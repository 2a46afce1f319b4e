#include "appearance/fish_look.h"

#include <algorithm>
#include <cmath>

namespace frond {

namespace {

constexpr Choice<TailShape> kTailShapes[] = {{"forked", TailShape::forked, "two lobes"},
                                             {"lunate", TailShape::lunate, "a crescent"},
                                             {"round", TailShape::round, "a fan"},
                                             {"square", TailShape::square, "cut straight"},
                                             {"shark", TailShape::shark, "the upper lobe much the longer"}};
constexpr Choice<DorsalShape> kDorsalShapes[] = {
    {"spiny", DorsalShape::spiny, "spines in front, a soft lobe behind"},
    {"sail", DorsalShape::sail, "a triangle, highest in front"},
    {"ribbon", DorsalShape::ribbon, "of one height from end to end"}};
constexpr Choice<FishPattern> kFishPatterns[] = {{"plain", FishPattern::plain, "dark above and pale below"},
                                                 {"bars", FishPattern::bars, "bars from back to belly"},
                                                 {"lines", FishPattern::lines, "lines from head to tail"},
                                                 {"spots", FishPattern::spots, "round spots"},
                                                 {"net", FishPattern::net, "a net of lines"}};

constexpr double kAnalFrom = 0.52, kAnalLength = 0.23;

}  // namespace

void describe(Properties& v, FishForm& f) {
  v.number("depth", f.depth, {.min = 0.05, .max = 0.9}, "Depth of the body, as a share of the length");
  v.number("width", f.width, {.min = 0.05, .max = 1.2}, "Width of the body, as a share of its depth");
  v.number("deepest", f.deepest, {.min = 0.15, .max = 0.7},
           "Where the body is deepest, as a share of it from the nose");
  v.number("arch", f.arch, {.min = -0.6, .max = 0.6},
           "By how much the back is more arched than the belly, as a share of half the depth");
  v.number("snout", f.snout, {.min = 0, .max = 1.5}, "How far the head is drawn out: 0 blunt, 1 a beak");
  v.number("peduncle", f.peduncle, {.min = 0.05, .max = 0.8},
           "Depth of the body before the tail, as a share of the greatest depth");
  v.choice("tail", f.tail, kTailShapes, "Shape of the tail");
  v.number("tail_depth", f.tail_depth, {.min = 0.02, .max = 1},
           "Depth of the tail, as a share of the length");
  v.choice("dorsal_shape", f.dorsal_shape, kDorsalShapes, "Shape of the fin on the back");
  v.number("dorsal", f.dorsal, {.min = 0, .max = 0.5},
           "Height of the fin on the back, as a share of the length");
  v.number("dorsal_from", f.dorsal_from, {.min = 0.1, .max = 0.7},
           "Where that fin begins, as a share of the length");
  v.number("dorsal_to", f.dorsal_to, {.min = 0.3, .max = 0.8},
           "Where it ends, as a share of the length; expected behind `dorsal_from`");
  v.number("sweep", f.sweep, {.min = 0, .max = 1.5},
           "How far the tips of the fins on back and belly trail behind, as a share of their height");
  v.number("anal", f.anal, {.min = 0, .max = 0.5}, "Height of the fin below, as a share of the length");
  v.number("pectoral", f.pectoral, {.min = 0, .max = 0.5},
           "Length of the fins at the sides, as a share of the length");
  v.number("spread", f.spread, {.min = 0, .max = 5},
           "How far these stand off the body: 0 along it, 1 as usual, 4 stiff to the sides");
}

void describe(Properties& v, FishPatch& p) {
  v.color("color", p.color, "Colour");
  v.vector("at", p.at, {.min = -4, .max = 5},
           "Where its middle is: share of the length from the nose, and of the depth there from below");
  v.vector("size", p.size, {.min = 0.005, .max = 4}, "Width and height, shares likewise");
  v.number("slant", p.slant, {.min = -2, .max = 2},
           "How far its top lies behind its foot, as a share of the length");
  v.number("soft", p.soft, {.min = 0.01, .max = 1}, "Softness of its edge, as a share of its size");
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
  v.color("mark", l.mark, "Colour of bars, lines, spots or the net");
  v.color("edge", l.edge, "Colour of their edges");
  v.number("edging", l.edging, {.min = 0, .max = 2}, "Width of the edges, as a share of half a mark's width");
  v.integer("marks", l.marks, {.min = 1, .max = 60},
            "Number of bars or lines; of spots or meshes of a net, how many lie along the fish");
  v.number("mark_width", l.mark_width, {.min = 0.002, .max = 0.5}, "Width of each, as a share of the length");
  v.number("mark_from", l.mark_from, {.min = -1, .max = 2},
           "Where the first is: of bars as a share of the length, of lines as a share of the depth from "
           "below; where "
           "spots or a net begin, likewise from below");
  v.number("mark_to", l.mark_to, {.min = -1, .max = 2}, "Where the last is");
  v.number("mark_slant", l.mark_slant, {.min = -2, .max = 2},
           "By how much lines rise toward the head, or bars lean forward, over the whole fish");
  v.number("mark_bow", l.mark_bow, {.min = -1, .max = 1},
           "By how much lines or bars are bowed in their middle");
  v.list("patches", l.patches, Count{0, 16}, "Saddles, bands through the eye and blotches, the last on top");
  v.boolean("marked_fins", l.marked_fins, "Whether bars, spots, nets and patches go on over the fins");
  v.color("iris", l.iris, "Colour of the eye round its pupil");
  v.number("eye", l.eye, {.min = 0, .max = 0.2}, "Width of the eye, as a share of the length");
  v.number("scales", l.scales, {.min = 0, .max = 1}, "How much scales show");
  v.number("gloss", l.gloss, {.min = 0, .max = 1}, "How much the fish shine");
  v.number("clear", l.clear, {.min = 0, .max = 1},
           "How much is seen through the skin of the fins: 0 nothing, 1 nearly all");
  v.integer("pixels", l.pixels, {.min = 32, .max = 2048}, "Width of the picture that they are painted with");
}

double fish_depth(const FishForm& form, double at) {
  constexpr double kBlunt = 0.5, kBeak = 0.7;  // power of the outline in front: 0.5 is round, 1 pointed
  constexpr double kFull = 0.85;               // power of it behind: the less, the fuller
  constexpr double kEarly = 1.04;              // it is as thin as it gets a little before the tail
  double t = std::clamp(at, 0.0, 1.0), peak = form.deepest;
  double shape = 0;
  if (t < peak) {
    shape = std::pow(std::sin(0.5 * kPi * t / peak), kBlunt + kBeak * form.snout);
  } else {
    double fall = (t - peak) / (1 - peak), ease = 0.5 + 0.5 * std::cos(kPi * std::min(1.0, kEarly * fall));
    shape = form.peduncle + (1 - form.peduncle) * std::pow(ease, kFull);
  }
  return 0.5 * form.depth * shape;
}

double fish_height(const FishForm& form, double at, double side) {
  return (1 + side * form.arch) * fish_depth(form, at);
}

Vec2 fish_eye(const FishForm& form) {
  constexpr double kBlunt = 0.105, kBeak = 0.04;  // where it is behind a blunt snout, and more behind a beak
  constexpr double kRaised = 0.32;                // by half of the depth there
  double along = kBlunt + kBeak * form.snout;
  return {static_cast<float>(along),
          static_cast<float>((kRaised + form.arch) * fish_depth(form, along / kFishBody))};
}

double dorsal_height(const FishForm& form, double at) {
  double t = (at - form.dorsal_from) / (form.dorsal_to - form.dorsal_from);
  if (t <= 0 || t >= 1) return 0;
  switch (form.dorsal_shape) {
    case DorsalShape::spiny:
      return form.dorsal * (0.75 * std::pow(std::sin(kPi * std::pow(t, 0.6)), 0.5) +
                            0.45 * std::exp(-std::pow((t - 0.82) / 0.12, 2)));
    case DorsalShape::sail:
      return form.dorsal * smooth_step(0.0, 0.35, t) * std::pow(1 - t, 1.6) * 2.1;
    case DorsalShape::ribbon:
      return form.dorsal * std::sqrt(smooth_step(0.0, 0.25, t) * (1 - smooth_step(0.85, 1.0, t)));
  }
  return 0;
}

double anal_height(const FishForm& form, double at) {
  double t = (at - kAnalFrom) / kAnalLength;
  return t <= 0 || t >= 1 ? 0 : form.anal * std::pow(std::sin(kPi * std::pow(t, 0.8)), 0.6) * (0.8 + 0.4 * t);
}

Vec2 fish_uv(double along, double up) {
  return {static_cast<float>(std::clamp(along, 0.002, 0.998)),
          static_cast<float>(std::clamp(0.5 + up / kFishSpan, 0.002, 0.998))};
}

Vec2 side_fin_uv(double across, double along) {
  return {static_cast<float>(kSideFin.left + kSideFin.wide * across),
          static_cast<float>(kSideFin.low + kSideFin.high * along)};
}

}  // namespace frond
