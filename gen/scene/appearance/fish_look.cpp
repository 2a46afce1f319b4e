#include "appearance/fish_look.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "appearance/paint.h"
#include "core/content.h"
#include "images/tiling_noise.h"
#include "preset/keys.h"

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

// Places and lengths are in lengths of the fish, marks and shades by eye.
constexpr double kSpan = 1.1;       // height of the picture
constexpr double kTailEdge = 0.02;  // half of what the tail's colour begins on
constexpr double kAnalFrom = 0.52, kAnalLength = 0.23;

/// 1 inside a band round `middle`, 0 outside, with a soft edge.
double band(double x, double middle, double half, double soft) {
  return 1 - smooth_step(half - soft, half + soft, std::abs(x - middle));
}

/// How much of a cell's mark is at a place, 0..1: of a spot, or of the net between them. A fish's length
/// holds `marks` cells, and marks are from `mark_from` to `mark_to` of the depth.
double cell_mark(const FishLook& look, double along, double up, double share) {
  constexpr int kCells = 64;  // until they repeat, more than there are
  constexpr double kSoft = 0.15;
  Cells cells = tiling_cells(along * look.marks + 8, up * look.marks + 32, kCells, kCells, Seed{11});
  double half = look.mark_width * look.marks / 2, soft = kSoft * half;
  double from = smooth_step(look.mark_from - 0.06, look.mark_from + 0.06, share),
         to = 1 - smooth_step(look.mark_to - 0.06, look.mark_to + 0.06, share);
  double mark = look.pattern == FishPattern::spots ? cells.nearest : (cells.second - cells.nearest) / 2;
  return from * to * (1 - smooth_step(half - soft, half + soft, mark));
}

/// Draws the marks over a colour.
Color marked(const FishLook& look, Color color, double along, double up, double share, double wobble) {
  if (look.pattern == FishPattern::plain) return color;
  if (look.pattern == FishPattern::spots || look.pattern == FishPattern::net)
    return mix(color, look.mark, cell_mark(look, along, up, share));
  constexpr double kSoftBar = 0.006, kSoftLine = 0.02;  // half of an edge; of lines by the depth
  constexpr double kLengthByDepth = 2.5;                // lines are measured across the depth
  constexpr double kWobble = 0.012;
  bool bars = look.pattern == FishPattern::bars;
  double x = bars ? along : share, across = bars ? share : along, half = look.mark_width / 2,
         soft = bars ? kSoftBar : kSoftLine;
  x += look.mark_slant * (across - 0.5) + look.mark_bow * 4 * across * (1 - across);
  if (!bars) half *= kLengthByDepth, soft = std::min(soft, half / 2);
  for (int i = 0; i < look.marks; ++i) {
    double t = look.marks > 1 ? static_cast<double>(i) / (look.marks - 1) : 0;
    double middle = look.mark_from + (look.mark_to - look.mark_from) * t + kWobble * wobble;
    if (bars) middle += 0.03 * std::sin(kPi * share) - 0.02;  // they bow forward at the flank
    if (look.edging > 0) color = mix(color, look.edge, band(x, middle, half * (1 + look.edging), soft));
    color = mix(color, look.mark, band(x, middle, half, soft));
  }
  return color;
}

/// Draws the patches over a colour.
Color patched(const FishLook& look, Color color, double along, double share) {
  for (const FishPatch& patch : look.patches) {
    Vec2 half = 0.5f * patch.size;
    double x = (along - static_cast<double>(patch.at.x) - patch.slant * (share - 0.5)) /
               static_cast<double>(half.x),
           y = (share - static_cast<double>(patch.at.y)) / static_cast<double>(half.y);
    color = mix(color, patch.color, 1 - smooth_step(1 - patch.soft, 1 + patch.soft, std::hypot(x, y)));
  }
  return color;
}

/// The rows of scales: darker where one lies over the next.
double scale_shade(double along, double up) {
  constexpr double kHigh = 0.016, kLong = 0.02;  // a scale
  double row = up / kHigh, column = along / kLong + 0.5 * (static_cast<int>(std::floor(row)) & 1);
  double y = row - std::floor(row) - 0.5, x = column - std::floor(column) - 0.5;
  constexpr double kRimFrom = 0.30, kRimTo = 0.56;  // from a scale's middle, by its size
  constexpr double kMean = 0.35;                    // about, so that scales do not darken it all
  return smooth_step(kRimFrom, kRimTo, std::hypot(x, y)) - kMean;
}

Color body_color(const FishForm& form, const FishLook& look, double along, double up) {
  double half = fish_depth(form, std::min(along / kFishBody, 1.0));
  double share = std::clamp(0.5 + 0.5 * up / std::max(half, 1e-3), 0.0, 1.0);  // 0 belly .. 1 back
  Color color = mix(look.belly, look.flank, smooth_step(0.08, 0.42, share));
  color = mix(color, look.back, smooth_step(0.55, 0.95, share));
  color = mix(color, look.tail, smooth_step(look.tail_from - kTailEdge, look.tail_from + kTailEdge, along));
  double wobble = std::sin(23 * along + 5) * std::sin(31 * up + 2);
  color = patched(look, marked(look, color, along, up, share, wobble), along, share);
  // The edge of the gill cover, part of an ellipse, and the mouth; each of them is darker by a share.
  constexpr double kGillAt = 0.10, kGillRadius = 0.125, kGillLong = 0.8, kGillFlat = 0.62, kGillWidth = 0.008;
  constexpr double kGillFrom = 0.12, kScalesFrom = 0.2, kMouthTo = 0.05;
  constexpr double kGillDark = 0.2, kScalesDark = 0.30, kMouthDark = 0.5;
  double gill = std::abs(std::hypot((along - kGillAt) / kGillLong, up * kGillFlat) - kGillRadius);
  if (along > kGillFrom) color = shaded(color, 1 - kGillDark * (1 - smooth_step(0.0, kGillWidth, gill)));
  if (along > kScalesFrom) color = shaded(color, 1 - kScalesDark * look.scales * scale_shade(along, up));
  if (along < kMouthTo) color = shaded(color, 1 - kMouthDark * band(up, -0.012 - 0.1 * along, 0.004, 0.003));
  return color;
}

/// The skin at a place, and how much of what lies behind it is hidden.
struct FishSkin {
  Color color;
  double opacity;
};

FishSkin fin_skin(const FishForm& form, const FishLook& look, double along, double up) {
  Color color =
      mix(look.fins, look.tail, smooth_step(look.tail_from - kTailEdge, look.tail_from + kTailEdge, along));
  if (look.marked_fins && look.pattern != FishPattern::lines)
    color = marked(look, color, along, up, up > 0 ? 1 : 0, 0);
  double half = fish_depth(form, std::min(along / kFishBody, 1.0));
  if (look.marked_fins)
    color = patched(look, color, along, 0.5 + 0.5 * up / std::max(half, 0.1 * form.depth));
  // Rays: along the tail, from a place before it, up and back on the other fins.
  constexpr double kFanFrom = 0.25, kFanRays = 46;  // how far before it, and how many by rise over run
  constexpr double kRays = 95, kBack = 0.35;        // on a length of fish; run by rise
  constexpr double kMean = 0.93, kRelief = 0.13;    // of their shade
  double across = along > kFishBody ? up / (kFanFrom + along - kFishBody) * kFanRays
                                    : (along - kBack * std::abs(up)) * kRays;
  // Those of fish without scales, as sharks are, are hidden.
  double shown = std::min(1.0, 4 * look.scales), ray = std::sin(2 * kPi * across);
  // A fin is flesh at its root and thins to its rim; its skin is clearest between the rays.
  constexpr double kFlesh = 0.02, kThin = 0.10;  // from the body, in lengths of the fish
  constexpr double kRayHides = 0.6;              // of what the skin lets through
  constexpr double kTail = 0.5;                  // share of what other fins let through
  double out = along > kFishBody ? along - kFishBody : std::abs(up) - half;
  double clear = look.clear * (along > kFishBody ? kTail : 1) * shown * smooth_step(kFlesh, kThin, out) *
                 (1 - kRayHides * (0.5 + 0.5 * ray));
  return {shaded(color, kMean + kRelief * shown * ray), 1 - clear};
}

Color eye_over(const FishForm& form, const FishLook& look, Color color, double along, double up) {
  const Vec2 eye = fish_eye(form);
  double middle = static_cast<double>(eye.x), raised = static_cast<double>(eye.y);
  // Socket, iris and pupil by the eye's radius, and a glint by its width.
  double r = std::hypot(along - middle, up - raised) / (look.eye / 2);
  color = mix(color, shaded(look.back, 0.5), 0.5 * (1 - smooth_step(1.0, 1.35, r)));
  color = mix(color, look.iris, 1 - smooth_step(0.92, 1.06, r));
  color = mix(color, {0.015f, 0.015f, 0.02f}, 1 - smooth_step(0.58, 0.68, r));
  double glint = std::hypot(along - middle + 0.12 * look.eye, up - raised - 0.14 * look.eye) / look.eye;
  return mix(color, {1, 1, 1}, 0.9 * (1 - smooth_step(0.06, 0.11, glint)));
}

/// 1 on the body, 0 on the fins. The body ends in the tail as a rounded wedge.
double flesh_share(const FishForm& form, double along, double up) {
  constexpr double kMiddle = 0.03, kRound = 0.05;   // how far it reaches into the tail; less at the edges
  constexpr double kBefore = 0.02, kAfter = 0.012;  // about its end, of which it fades
  double half = fish_depth(form, std::min(along / kFishBody, 1.0));
  if (std::abs(up) >= half + 0.004) return 0;
  double end = kFishBody + kMiddle - kRound * std::pow(up / half, 2);
  return 1 - smooth_step(end - kBefore, end + kAfter, along);
}

FishSkin fish_skin(const FishForm& form, const FishLook& look, double along, double up) {
  double flesh = flesh_share(form, along, up);
  if (flesh <= 0) return fin_skin(form, look, along, up);
  Color body = eye_over(form, look, body_color(form, look, along, up), along, up);
  if (flesh >= 1) return {body, 1};
  FishSkin fin = fin_skin(form, look, along, up);
  return {mix(fin.color, body, flesh), std::lerp(fin.opacity, 1.0, flesh)};
}

Raster fish_picture(const FishForm& form, const FishLook& look) {
  int wide = look.pixels, high = static_cast<int>(std::lround(kSpan * look.pixels));
  Raster picture(wide, high, look.clear > 0 ? 4 : 3);
  for (int y = 0; y < high; ++y)
    for (int x = 0; x < wide; ++x) {
      double along = (x + 0.5) / wide, up = kSpan * (0.5 - (y + 0.5) / high);
      FishSkin skin = fish_skin(form, look, along, up);
      std::uint8_t* pixel = &picture.data[picture.index(x, y)];
      pixel[0] = to_byte(skin.color.red), pixel[1] = to_byte(skin.color.green),
      pixel[2] = to_byte(skin.color.blue);
      if (picture.channels == 4) pixel[3] = to_byte(static_cast<float>(skin.opacity));
    }
  return picture;
}

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

Vec2 fish_eye(const FishForm& form) {
  constexpr double kBlunt = 0.105, kBeak = 0.04;  // where it is behind a blunt snout, and more behind a beak
  constexpr double kRaised = 0.32;                // by half of the depth there
  double along = kBlunt + kBeak * form.snout;
  return {static_cast<float>(along), static_cast<float>(kRaised * fish_depth(form, along / kFishBody))};
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
          static_cast<float>(std::clamp(0.5 + up / kSpan, 0.002, 0.998))};
}

std::string fish_picture_name(const FishForm& form, const FishLook& look) {
  return fmt::format("fish_{}.png", made_id(keys_of(form, look).all()));
}

Drawing fish_drawing(const FishForm& form, const FishLook& look) {
  constexpr double kSecondsAPixel = 4e-7;
  return drawing_of(fish_picture_name(form, look), kSpan * look.pixels * look.pixels, kSecondsAPixel,
                    [form, look] { return fish_picture(form, look); });
}

}  // namespace frond
