#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "appearance/fish_look.h"
#include "appearance/paint.h"
#include "core/content.h"
#include "images/tiling_noise.h"
#include "preset/keys.h"

namespace frond {

namespace {

// Places and lengths are in lengths of the fish, marks and shades by eye.
constexpr double kTailEdge = 0.02;                       // half of what the tail's colour begins on
constexpr double kScaleLong = 0.02, kScaleHigh = 0.016;  // of a scale
constexpr double kScalesFrom = 0.2;                      // from the nose; the face has none

/// 1 inside a band round `middle`, 0 outside, with a soft edge.
double band(double x, double middle, double half, double soft) {
  return 1 - smooth_step(half - soft, half + soft, std::abs(x - middle));
}

/// How high a place is on the body, 0 belly .. 1 back, less or more on fins. Where the body is thinner than
/// `least`, it counts as so deep.
double share_of_depth(const FishForm& form, double along, double up, double least) {
  double half = std::max(fish_depth(form, std::min(along / kFishBody, 1.0)), least);
  return 0.5 * (1 - form.arch + up / half);
}

/// A scale: its middle, where a place is on it from there, by its size, and its own number.
struct Scale {
  double along, up, x, y;
  std::uint64_t number;
};
Scale scale_at(double along, double up) {
  double row = std::floor(up / kScaleHigh), odd = row - 2 * std::floor(row / 2);
  double column = std::floor(along / kScaleLong + 0.5 * odd);
  Scale at{(column + 0.5 - 0.5 * odd) * kScaleLong, (row + 0.5) * kScaleHigh, 0, 0, 0};
  at.x = (along - at.along) / kScaleLong, at.y = (up - at.up) / kScaleHigh;
  at.number = static_cast<std::uint64_t>(row + 1000) * 4096 + static_cast<std::uint64_t>(column + 8);
  return at;
}

/// How far a place lies behind the edge of the gill cover, part of an ellipse; below 0 on the cover.
double behind_gill(double along, double up) {
  constexpr double kAt = 0.10, kRadius = 0.125, kLong = 0.8, kFlat = 0.62;
  return std::hypot((along - kAt) / kLong, up * kFlat) - kRadius;
}

/// How far a place is above the line of the mouth, which falls to the corner, and 1 between the lips, 0 from
/// the corner on. The mouth of a shark is below its snout.
struct Mouth {
  double above, there;
};
Mouth mouth_at(const FishForm& form, double along, double up) {
  if (form.tail == TailShape::shark) {
    constexpr double kFrom = 0.055, kTo = 0.115;
    double line = -0.55 * fish_height(form, along / kFishBody, -1) - 0.15 * (kTo - along);
    return {up - line, smooth_step(kFrom, kFrom + 0.01, along) * (1 - smooth_step(kTo - 0.01, kTo, along))};
  }
  constexpr double kLong = 0.062, kBeakShorter = 0.022;  // of a blunt head; less of a beak
  double end = kLong - kBeakShorter * std::min(form.snout, 1.5);
  return {up + 0.006 + 0.22 * along + 2.2 * along * along, 1 - smooth_step(0.75 * end, end, along)};
}

/// How much of a gill slit of a shark is at a place: five, the last above the root of the fore fin.
double slit_at(const FishForm& form, double along, double up) {
  if (form.tail != TailShape::shark) return 0;
  constexpr double kFirst = 0.185, kApart = 0.0145, kHalf = 0.0022;
  double share = share_of_depth(form, along, up, 0), tall = band(share, 0.47, 0.19, 0.03);
  double bowed = along - 0.012 * std::pow((share - 0.47) / 0.19, 2), nearest = 1;
  for (int i = 0; i < 5; ++i) nearest = std::min(nearest, std::abs(bowed - kFirst - kApart * i));
  return tall * (1 - smooth_step(0.5 * kHalf, 1.6 * kHalf, nearest));
}

/// How much of the rays of fins is seen: of sharks, which have no scales, nothing.
double rays_shown(const FishLook& look) { return std::min(1.0, 4 * look.scales); }

/// A wave over the rays of fins, -1 between two .. 1 on one: along the tail, from a place before it, up and
/// back on the other fins.
double ray_at(const FishLook& look, double along, double up) {
  constexpr double kFanFrom = 0.25, kFanRays = 27;  // how far before the tail, and how many by rise over run
  constexpr double kRays = 54, kBack = 0.35;        // on a length of fish; run by rise
  double across = along > kFishBody ? up / (kFanFrom + along - kFishBody) * kFanRays
                                    : (along - kBack * std::abs(up)) * kRays;
  return rays_shown(look) * std::sin(2 * kPi * across);
}

/// The same on a fin at the sides.
double side_ray_at(const FishLook& look, double across) {
  constexpr double kRays = 9;
  return rays_shown(look) * std::sin(2 * kPi * kRays * across);
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

Color body_color(const FishForm& form, const FishLook& look, double along, double up) {
  // Edges of marks follow scales, each of which has a colour of its own.
  constexpr double kByScale = 0.7, kOwn = 0.11, kCloud = 0.16;
  double scaly = along > kScalesFrom ? look.scales : 0;
  Scale scale = scale_at(along, up);
  double x = std::lerp(along, scale.along, kByScale * scaly), y = std::lerp(up, scale.up, kByScale * scaly);
  double share = std::clamp(share_of_depth(form, x, y, 1e-3), 0.0, 1.0);
  double cloud = tiling_fractal(9 * along + 3, 9 * up + 32, 64, 64, 4, 0.55, Seed{17});
  Color color = mix(look.belly, look.flank, smooth_step(0.08, 0.42, share + 0.05 * cloud));
  color = mix(color, look.back, smooth_step(0.55, 0.95, share + 0.05 * cloud));
  color = mix(color, look.tail, smooth_step(look.tail_from - kTailEdge, look.tail_from + kTailEdge, x));
  double wobble = std::sin(23 * along + 5) * std::sin(31 * up + 2) + 0.5 * cloud;
  color = patched(look, marked(look, color, x, y, share, wobble), x, share);
  color = shaded(color, 1 + kCloud * cloud + kOwn * scaly * Seed{23}.child(scale.number).range(-1, 1));
  // Darker are the rims of scales, where one lies over the next, what the gill cover shades, and between
  // lips.
  constexpr double kRimFrom = 0.30, kRimTo = 0.56, kRimMean = 0.35, kRimDark = 0.24;
  constexpr double kGillFrom = 0.12, kGillLine = 0.007, kGillShade = 0.035, kGillDark = 0.32, kGillDim = 0.16;
  constexpr double kLipHalf = 0.0035, kLipSoft = 0.0025, kMouthDark = 0.8, kSlitDark = 0.6;
  double rim = smooth_step(kRimFrom, kRimTo, std::hypot(scale.x, scale.y)) - kRimMean;
  color = shaded(color, 1 - kRimDark * scaly * rim);
  if (along > kGillFrom && form.tail != TailShape::shark) {
    double off = behind_gill(along, up), after = off > 0 ? 1 - smooth_step(0.0, kGillShade, off) : 0;
    color =
        shaded(color, 1 - kGillDark * (1 - smooth_step(0.0, kGillLine, std::abs(off))) - kGillDim * after);
  }
  Mouth mouth = mouth_at(form, along, up);
  color = shaded(color, 1 - kMouthDark * mouth.there * band(mouth.above, 0, kLipHalf, kLipSoft));
  return shaded(color, 1 - kSlitDark * slit_at(form, along, up));
}

/// A colour as a fish wears it: pigments are less pure than paint.
Color worn(const Color& color) {
  constexpr float kGrey = 0.14f, kBright = 0.86f;
  float grey = (color.red + color.green + color.blue) / 3;
  return {kBright * std::lerp(color.red, grey, kGrey), kBright * std::lerp(color.green, grey, kGrey),
          kBright * std::lerp(color.blue, grey, kGrey)};
}

/// The skin at a place, and how much of what lies behind it is hidden.
struct FishSkin {
  Color color;
  double opacity;
};

/// A fin's skin of a colour: flesh at its root, thinner to its rim and clearest between its rays. `out` from
/// its root, in lengths of the fish.
FishSkin ray_skin(const FishLook& look, const Color& color, double ray, double out, double lets_through) {
  constexpr double kMean = 0.90, kRelief = 0.20;  // of the shade of rays
  constexpr double kFlesh = 0.02, kThin = 0.10;
  constexpr double kRayHides = 0.6;  // of what the skin lets through
  double clear = look.clear * lets_through * rays_shown(look) * smooth_step(kFlesh, kThin, out) *
                 (1 - kRayHides * (0.5 + 0.5 * ray));
  return {shaded(color, kMean + kRelief * ray), 1 - clear};
}

FishSkin fin_skin(const FishForm& form, const FishLook& look, double along, double up) {
  Color color =
      mix(look.fins, look.tail, smooth_step(look.tail_from - kTailEdge, look.tail_from + kTailEdge, along));
  if (look.marked_fins && look.pattern != FishPattern::lines)
    color = marked(look, color, along, up, up > 0 ? 1 : 0, 0);
  if (look.marked_fins)
    color = patched(look, color, along, share_of_depth(form, along, up, 0.1 * form.depth));
  constexpr double kTail = 0.5;                   // share of what other fins let through
  constexpr double kRimFrom = 0.7, kRimTo = 0.9;  // of a fin's height
  if (along > kFishBody) return ray_skin(look, color, ray_at(look, along, up), along - kFishBody, kTail);
  double out = std::abs(up) - fish_height(form, along / kFishBody, up > 0 ? 1 : -1);
  double high = up > 0 ? dorsal_height(form, along) : anal_height(form, along);
  if (look.marked_fins && look.edging > 0 && high > 0)
    color = mix(color, look.edge, smooth_step(kRimFrom, kRimTo, out / high));
  return ray_skin(look, color, ray_at(look, along, up), out, 1);
}

FishSkin side_fin_skin(const FishLook& look, double across, double along) {
  constexpr double kLong = 0.16;  // about its length
  return ray_skin(look, look.fins, side_ray_at(look, across), kLong * along, 1);
}

Color eye_over(const FishForm& form, const FishLook& look, Color color, double along, double up) {
  const Vec2 eye = fish_eye(form);
  double middle = static_cast<double>(eye.x), raised = static_cast<double>(eye.y);
  // Socket, iris and pupil by the eye's radius, and a glint by its width.
  double r = std::hypot(along - middle, up - raised) / (look.eye / 2);
  color = mix(color, shaded(look.back, 0.5), 0.5 * (1 - smooth_step(1.0, 1.35, r)));
  color =
      mix(color, shaded(look.iris, 0.72 + 0.4 * smooth_step(0.95, 0.7, r)), 1 - smooth_step(0.92, 1.06, r));
  color = mix(color, {0.015f, 0.015f, 0.02f}, 1 - smooth_step(0.58, 0.68, r));
  double glint = std::hypot(along - middle + 0.12 * look.eye, up - raised - 0.14 * look.eye) / look.eye;
  return mix(color, {1, 1, 1}, 0.8 * (1 - smooth_step(0.05, 0.09, glint)));
}

/// 1 on the body, 0 on the fins. The body ends in the tail as a rounded wedge.
double flesh_share(const FishForm& form, double along, double up) {
  constexpr double kMiddle = 0.03, kRound = 0.05;   // how far it reaches into the tail; less at the edges
  constexpr double kBefore = 0.02, kAfter = 0.012;  // about its end, of which it fades
  double half = fish_height(form, std::min(along / kFishBody, 1.0), up > 0 ? 1 : -1);
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

constexpr double kSkinHeight = 0.4, kRayHeight = 0.07;  // of the skin on average; of rays of fins above it

/// The height of the skin, 0..1: scales lie over each other as shingles, the gill cover stands off, lips
/// swell.
double fish_relief_at(const FishForm& form, const FishLook& look, double along, double up) {
  constexpr double kScale = 0.16, kCover = 0.22, kCoverLong = 0.05, kLip = 0.2, kLipWide = 0.008, kSlit = 0.3,
                   kGrain = 0.05;
  double flesh = flesh_share(form, along, up);
  double fin = kSkinHeight + kRayHeight * ray_at(look, along, up);
  if (flesh <= 0) return fin;
  double body = kSkinHeight + kGrain * tiling_fractal(40 * along, 40 * up + 32, 128, 128, 3, 0.6, Seed{19});
  if (along > kScalesFrom) {
    Scale scale = scale_at(along, up);
    body += kScale * look.scales * (0.5 - scale.x * scale.x - scale.y * scale.y);
  }
  if (form.tail != TailShape::shark) {
    double off = behind_gill(along, up);
    body += kCover * (off < 0 ? std::max(0.0, 1 + off / kCoverLong) : 1 - smooth_step(0.0, 0.008, off)) *
            smooth_step(0.1, 0.15, along);
  }
  Mouth mouth = mouth_at(form, along, up);
  double lip = std::abs(mouth.above) / kLipWide;
  body += kLip * mouth.there * (lip < 2 ? std::sin(kPi * lip / 2) - (lip < 0.4 ? 0.8 : 0) : 0);
  body -= kSlit * slit_at(form, along, up);
  return std::lerp(fin, body, flesh);
}

/// Calls `paint(pixel, along, up, false)` for all pixels of a fish's picture but those of the corner that
/// holds a fin at the sides; for these `paint(pixel, across, along, true)`, its places across its rays and
/// along them.
template <typename Paint>
Raster painted(int pixels, int channels, Paint paint) {
  int wide = pixels, high = static_cast<int>(std::lround(kFishSpan * pixels));
  Raster picture(wide, high, channels);
  for (int y = 0; y < high; ++y)
    for (int x = 0; x < wide; ++x) {
      double u = (x + 0.5) / wide, v = 1 - (y + 0.5) / high;
      double across = (u - kSideFin.left) / kSideFin.wide, out = (v - kSideFin.low) / kSideFin.high;
      bool side_fin = across < 1.1 && out > -0.1;
      paint(&picture.data[picture.index(x, y)], side_fin ? across : u, side_fin ? out : kFishSpan * (v - 0.5),
            side_fin);
    }
  return picture;
}

Raster fish_picture(const FishForm& form, const FishLook& look) {
  int channels = look.clear > 0 ? 4 : 3;
  return painted(look.pixels, channels, [&](std::uint8_t* pixel, double along, double up, bool side_fin) {
    FishSkin skin = side_fin ? side_fin_skin(look, along, up) : fish_skin(form, look, along, up);
    Color color = worn(skin.color);
    pixel[0] = to_byte(color.red), pixel[1] = to_byte(color.green), pixel[2] = to_byte(color.blue);
    if (channels == 4) pixel[3] = to_byte(static_cast<float>(skin.opacity));
  });
}

Raster relief_picture(const FishForm& form, const FishLook& look) {
  return painted(look.pixels, 1, [&](std::uint8_t* pixel, double along, double up, bool side_fin) {
    double height = side_fin ? kSkinHeight + kRayHeight * side_ray_at(look, along)
                             : fish_relief_at(form, look, along, up);
    *pixel = to_byte(static_cast<float>(std::clamp(height, 0.0, 1.0)));
  });
}

}  // namespace

std::string fish_picture_name(const FishForm& form, const FishLook& look) {
  return fmt::format("fish_{}.png", made_id(keys_of(form, look).all()));
}

std::string fish_relief_name(const FishForm& form, const FishLook& look) {
  FishLook shape;  // what no height depends on is left as it is
  shape.scales = look.scales, shape.pixels = look.pixels;
  return fmt::format("fish_{}_relief.png", made_id(keys_of(form, shape).all()));
}

Drawing fish_drawing(const FishForm& form, const FishLook& look) {
  constexpr double kSecondsAPixel = 6e-7;
  return drawing_of(fish_picture_name(form, look), kFishSpan * look.pixels * look.pixels, kSecondsAPixel,
                    [form, look] { return fish_picture(form, look); });
}

Drawing fish_relief(const FishForm& form, const FishLook& look) {
  constexpr double kSecondsAPixel = 3e-7;
  return drawing_of(fish_relief_name(form, look), kFishSpan * look.pixels * look.pixels, kSecondsAPixel,
                    [form, look] { return relief_picture(form, look); });
}

}  // namespace frond
