#include "appearance/swimmer_look.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "appearance/paint.h"
#include "core/content.h"
#include "images/tiling_noise.h"
#include "preset/keys.h"

namespace frond {

namespace {

// What is in the picture of a turtle or a manta, in units of the animal: half of it, since it is symmetric,
// from below in the lower half of the picture and from above in the upper one.
constexpr double kAlongFrom = -0.12, kAlongs = 1.3, kAside = 0.75;
constexpr double kBellFrom = 0.5, kArmFrom = 0.25;  // of the height of a jellyfish's picture

/// 1 on a line at 0, 0 from `half` on.
double line(double distance, double half) { return 1 - smooth_step(0.5 * half, half, std::abs(distance)); }

/// How far a number is from the nearest whole one.
double off_whole(double x) { return std::abs(x - std::round(x)); }

double grain(double x, double y, int octaves) { return tiling_fractal(x, y, 64, 64, octaves, 0.55, Seed{3}); }

/// The horny plates of a shell: five along the middle, four on each side between them, and a row round the
/// rim. `share` along the shell, `aside` 0 middle .. 1 rim.
Color scute_color(const FishLook& look, double share, double aside) {
  constexpr double kMiddle = 0.33, kZigzag = 0.16, kRim = 0.86, kRimPlates = 12;
  constexpr double kSeam = 0.009, kSeamAside = 0.025;
  double column = 5 * share, inner = kMiddle + kZigzag * (0.25 - off_whole(column - 0.5)), seam = 0;
  Vec2 heart;  // of the plate, from which streaks run
  if (aside < inner) {
    heart = {static_cast<float>((std::floor(column) + 0.8) / 5), 0.0f};
    seam = std::max(line(off_whole(column), kSeam * 5), line(aside - inner, kSeamAside));
  } else if (aside < kRim) {
    heart = {static_cast<float>((std::floor(column - 0.5) + 1.3) / 5), 0.68f};
    seam = std::max({line(off_whole(column - 0.5), kSeam * 5), line(aside - inner, kSeamAside),
                     line(aside - kRim, kSeamAside)});
  } else {
    heart = {static_cast<float>((std::floor(kRimPlates * share) + 0.7) / kRimPlates), 1.0f};
    seam = std::max(line(off_whole(kRimPlates * share), kSeam * kRimPlates), line(aside - kRim, kSeamAside));
  }
  double x = share - static_cast<double>(heart.x), y = 0.4 * (aside - static_cast<double>(heart.y));
  double angle = std::atan2(y, x), far = std::hypot(x, y);
  double streak = grain(5 * angle + 17 * static_cast<double>(heart.x + heart.y) + 32, 6 * far + 9, 3);
  Color color = mix(look.back, look.flank,
                    smooth_step(-0.3, 0.4, streak) * (0.35 + 0.65 * smooth_step(0.0, 0.08, far)));
  color = shaded(color, 0.92 + 0.3 * grain(30 * share, 14 * aside, 3));  // what grows on it
  return mix(color, mix(look.mark, look.back, 0.5), 0.6 * seam);
}

Color turtle_color(const FishLook& look, double along, double aside, bool above) {
  constexpr int kScales = 30;  // on its length
  double share = (along - kShellFrom) / (kShellTo - kShellFrom);
  double wide = share > 0 && share < 1 ? shell_width(share) : 0;
  bool shell = wide > 0 && aside < wide;
  if (shell && above) return scute_color(look, share, aside / wide);
  double mottle = grain(9 * along + 3, 9 * aside + 3, 3);
  Color pale = shaded(look.belly, 0.94 + 0.1 * mottle);
  if (shell) {
    double seam = std::max(line(off_whole(6 * share), 0.05), line(aside, 0.004));
    return mix(pale, shaded(look.belly, 0.75), 0.6 * seam);
  }
  // Scales with pale seams: dark from above, from below only toward the edges.
  Cells cells = tiling_cells(kScales * (along + 0.2), kScales * aside, 64, 64, Seed{5});
  double dark = smooth_step(0.05, 0.16, cells.second - cells.nearest);
  if (!above) dark *= smooth_step(0.42, 0.62, aside + 0.2 * mottle);
  Color scale = mix(look.back, look.flank, 0.15 + 0.5 * (cells.own - 0.5) + 0.3 * mottle);
  return mix(above ? look.mark : pale, scale, dark);
}

Color manta_color(const FishLook& look, double along, double aside, bool above) {
  double cloud = grain(7 * along + 5, 7 * aside + 5, 4);
  // The mouth is seen from the front, between the fins of the head.
  double mouth = (1 - smooth_step(0.09, 0.11, aside)) * (1 - smooth_step(0.05, 0.065, along));
  if (above) {
    Color color = shaded(look.back, 1 + 0.25 * cloud);
    // Pale shoulders, which end before the middle, and a pale edge behind.
    double slope =
        along - 0.15 - 0.10 * std::pow(std::abs(aside - 0.19) / 0.15, 2) * (aside > 0.19 ? 1.4 : 1);
    double shoulder = smooth_step(-0.012, 0.004, slope) *
                      (1 - smooth_step(0.0, 0.085, slope + 0.04 * cloud)) * smooth_step(0.05, 0.09, aside) *
                      (1 - smooth_step(0.28, 0.36, aside));
    color = mix(color, look.mark, (0.7 + 0.5 * cloud) * shoulder);
    double tip = smooth_step(0.40, 0.47, aside) * 0.35;
    return mix(color, look.flank, tip + 0.12 * smooth_step(0.0, 0.5, cloud));
  }
  Color color = shaded(look.belly, 0.97 + 0.06 * cloud);
  double edge = smooth_step(0.27, 0.42, aside + 0.3 * (along - 0.25) + 0.05 * cloud);
  color = mix(color, look.back, 0.75 * edge);
  // Five gills on each side, and spots between and behind them.
  for (int gill = 0; gill < 5; ++gill) {
    double at = 0.125 + 0.03 * gill + 0.12 * (aside - 0.09);
    double within = smooth_step(0.055, 0.065, aside) *
                    (1 - smooth_step(0.125 - 0.012 * gill, 0.14 - 0.012 * gill, aside));
    color = mix(color, shaded(look.edge, 0.8), 0.85 * within * line(along - at, 0.006));
  }
  Cells cells = tiling_cells(22 * (along + 0.2), 22 * aside, 64, 64, Seed{8});
  double room = smooth_step(0.2, 0.3, along) * (1 - smooth_step(0.16, 0.22, aside));
  double spot =
      cells.own > 0.55 ? 1 - smooth_step(0.18 + 0.14 * cells.own, 0.26 + 0.14 * cells.own, cells.nearest) : 0;
  color = mix(color, look.edge, 0.9 * room * spot);
  return mix(color, {0.03f, 0.03f, 0.035f}, mouth);
}

/// Colour and, as its fourth number, opacity.
struct Film {
  Color color;
  double opacity;
};

Film bell_film(const FishLook& look, double round, double along) {
  double cloud = grain(20 * round, 6 * along + 4, 4);
  Film film{mix(look.back, look.flank, along), 0.42 + 0.2 * along + 0.15 * cloud};
  auto ink = [&](const Color& color, double opacity, double share) {
    film.color = mix(film.color, color, share);
    film.opacity += (opacity - film.opacity) * std::clamp(share, 0.0, 1.0);
  };
  // Canals to the rim, finer the more there are; broad lines as a compass has them.
  ink(look.mark, 0.6, 0.5 * line(off_whole(64 * round) / 64, 0.0035) * smooth_step(0.3, 0.6, along));
  if (look.pattern == FishPattern::lines) {
    double half = look.mark_width * (0.35 + 0.65 * along) / 2;
    double off = off_whole(look.marks * round) / look.marks;
    ink(look.mark, 0.92, line(off + 0.004 * cloud, half) * smooth_step(0.18, 0.5, along + 0.1 * cloud));
  }
  if (look.pattern == FishPattern::spots) {  // four horseshoes round the middle
    double off = off_whole(4 * round) / 4 * 2 * kPi, x = 0.3 - along * std::cos(off),
           y = along * std::sin(off);
    double ring = std::hypot(x, y) - 0.13;
    ink(look.mark, 0.95, line(ring, 0.05) * smooth_step(-0.12, -0.05, x));
  }
  ink(look.edge, 0.85, smooth_step(0.93, 0.99, along) * 0.7);
  return film;
}

Film arm_film(const FishLook& look, double across, double along) {
  double edge = std::abs(2 * across - 1), cloud = grain(30 * along, 4 * across, 3);
  return {mix(look.belly, look.flank, 0.5 * edge + 0.4 * cloud),
          (0.72 + 0.25 * cloud - 0.25 * smooth_step(0.5, 1.0, edge)) * (1 - 0.5 * along)};
}

Film jelly_film(const FishLook& look, double across, double v) {
  if (v >= kBellFrom) return bell_film(look, across, 1 - (v - kBellFrom) / (1 - kBellFrom));
  if (v >= kArmFrom) return arm_film(look, across, 1 - (v - kArmFrom) / (kBellFrom - kArmFrom));
  return {look.tail, 0.85 - 0.4 * (1 - v / kArmFrom)};
}

void paint(std::uint8_t* pixel, const Color& color) {
  pixel[0] = to_byte(color.red), pixel[1] = to_byte(color.green), pixel[2] = to_byte(color.blue);
}

/// Width by height of the picture.
double flatness(SeaAnimal animal) { return animal == SeaAnimal::jellyfish ? 1 : kAlongs / (2 * kAside); }

Raster swimmer_picture(SeaAnimal animal, const FishLook& look) {
  constexpr double kEyeCorner = 0.02;  // of the picture's width and height
  int wide = look.pixels, high = static_cast<int>(std::lround(wide / flatness(animal)));
  bool clear = animal == SeaAnimal::jellyfish;
  Raster picture(wide, high, clear ? 4 : 3);
  for (int y = 0; y < high; ++y)
    for (int x = 0; x < wide; ++x) {
      double u = (x + 0.5) / wide, v = 1 - (y + 0.5) / high;
      std::uint8_t* pixel = &picture.data[picture.index(x, y)];
      if (clear) {
        Film film = jelly_film(look, u, v);
        paint(pixel, film.color);
        pixel[3] = to_byte(static_cast<float>(std::clamp(film.opacity, 0.0, 1.0)));
        continue;
      }
      double along = kAlongFrom + kAlongs * u, aside = 2 * kAside * (v - (v >= 0.5 ? 0.5 : 0));
      bool eye = u < kEyeCorner && v > 1 - kEyeCorner;
      auto color = animal == SeaAnimal::turtle ? turtle_color : manta_color;
      paint(pixel, eye ? Color{0.012f, 0.012f, 0.014f} : color(look, along, aside, v >= 0.5));
    }
  return picture;
}

}  // namespace

Vec2 plan_uv(double along, double aside, bool above) {
  double v = 0.5 * std::clamp(std::abs(aside) / kAside, 0.002, 0.998) + (above ? 0.5 : 0);
  return {static_cast<float>(std::clamp((along - kAlongFrom) / kAlongs, 0.002, 0.998)),
          static_cast<float>(v)};
}

Vec2 eye_uv() { return {0.008f, 0.992f}; }

Vec2 jelly_uv(JellyPart part, double across, double along) {
  double from = part == JellyPart::bell  ? kBellFrom
                : part == JellyPart::arm ? kArmFrom
                                         : 0,
         to = part == JellyPart::bell  ? 1
              : part == JellyPart::arm ? kBellFrom
                                       : kArmFrom;
  constexpr double kInside = 0.004;  // of the picture, so that parts do not mix
  return {static_cast<float>(std::clamp(across, 0.002, 0.998)),
          static_cast<float>(to - kInside - (to - from - 2 * kInside) * std::clamp(along, 0.0, 1.0))};
}

double shell_width(double share) {
  constexpr double kWidest = 0.42, kHalf = 0.30;  // share of the shell; lengths of the turtle
  double t = std::clamp(share, 0.0, 1.0);
  return kHalf * (t < kWidest ? std::pow(std::sin(0.5 * kPi * t / kWidest), 0.42)
                              : std::pow(std::cos(0.5 * kPi * (t - kWidest) / (1 - kWidest)), 0.78));
}

std::string swimmer_picture_name(SeaAnimal animal, const FishForm& form, const FishLook& look) {
  if (animal == SeaAnimal::fish) return fish_picture_name(form, look);
  return fmt::format("swimmer{}_{}.png", static_cast<int>(animal), made_id(keys_of(look).all()));
}

Drawing swimmer_drawing(SeaAnimal animal, const FishForm& form, const FishLook& look) {
  if (animal == SeaAnimal::fish) return fish_drawing(form, look);
  constexpr double kSecondsAPixel = 2e-6;
  return drawing_of(swimmer_picture_name(animal, form, look), look.pixels * look.pixels / flatness(animal),
                    kSecondsAPixel, [animal, look] { return swimmer_picture(animal, look); });
}

FishLook varied(const FishLook& look, double variation, Seed seed) {
  FishLook other = look;
  double bright = seed.child("bright").range(-1, 1);
  auto change = [&](float& part, std::uint64_t which) {
    constexpr double kHue = 0.45;  // of the change of a colour alone
    double by = 1 + variation * ((1 - kHue) * bright + kHue * seed.child(which).range(-1, 1));
    part = std::clamp(part * static_cast<float>(by), 0.0f, 1.0f);
  };
  for (Color* color : {&other.back, &other.flank, &other.belly, &other.fins, &other.tail})
    change(color->red, 0), change(color->green, 1), change(color->blue, 2);
  // No two wear quite the same marks.
  constexpr double kWidth = 1.2, kShift = 0.12, kTurn = 0.25;  // of the variation of colours
  auto some = [&](std::string_view what, double most) {
    return most * variation * seed.child(what).range(-1, 1);
  };
  other.mark_width *= 1 + some("width", kWidth);
  other.mark_from += some("from", kShift), other.mark_to += some("to", kShift);
  other.mark_slant += some("slant", kTurn), other.mark_bow += some("bow", kTurn);
  for (FishPatch& patch : other.patches) {
    std::uint64_t which = static_cast<std::uint64_t>(&patch - other.patches.data());
    auto by = [&](std::string_view what) {
      return static_cast<float>(kWidth * variation * seed.child(what, which).range(-1, 1));
    };
    patch.size *= Vec2(1 + by("wide"), 1 + by("high"));
  }
  return other;
}

}  // namespace frond
