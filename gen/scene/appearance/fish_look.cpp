#include "appearance/fish_look.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "appearance/describe_fish.h"
#include "core/content.h"
#include "preset/keys.h"

namespace frond {

namespace {

constexpr double kSpan = 1.1;  // height of the picture, in lengths of the fish

Color mix(const Color& a, const Color& b, double t) {
  return mixed(a, b, static_cast<float>(std::clamp(t, 0.0, 1.0)));
}

Color shaded(const Color& c, double by) {
  auto f = static_cast<float>(by);
  return {c.red * f, c.green * f, c.blue * f};
}

/// 1 inside a band round `middle`, 0 outside, with a soft edge.
double band(double x, double middle, double half, double soft) {
  return 1 - smooth_step(half - soft, half + soft, std::abs(x - middle));
}

/// Draws the marks over a colour.
Color marked(const FishLook& look, Color color, double along, double share, double wobble) {
  if (look.pattern == FishPattern::plain) return color;
  bool bars = look.pattern == FishPattern::bars;
  double x = bars ? along : share, half = look.mark_width / 2, soft = bars ? 0.006 : 0.02;
  if (!bars) half *= 2.5;  // lines are measured across the depth
  for (int i = 0; i < look.marks; ++i) {
    double t = look.marks > 1 ? static_cast<double>(i) / (look.marks - 1) : 0;
    double middle = look.mark_from + (look.mark_to - look.mark_from) * t + 0.012 * wobble;
    if (bars) middle += 0.03 * std::sin(kPi * share) - 0.02;  // they bow forward at the flank
    if (look.edging > 0) color = mix(color, look.edge, band(x, middle, half * (1 + look.edging), soft));
    color = mix(color, look.mark, band(x, middle, half, soft));
  }
  return color;
}

/// The rows of scales: darker where one lies over the next.
double scale_shade(double along, double up) {
  double row = up / 0.016, column = along / 0.02 + 0.5 * (static_cast<int>(std::floor(row)) & 1);
  double y = row - std::floor(row) - 0.5, x = column - std::floor(column) - 0.5;
  return smooth_step(0.30, 0.56, std::hypot(x, y)) - 0.35;
}

Color body_color(const FishForm& form, const FishLook& look, double along, double up) {
  double half = fish_depth(form, std::min(along / kFishBody, 1.0));
  double share = std::clamp(0.5 + 0.5 * up / std::max(half, 1e-3), 0.0, 1.0);  // 0 belly .. 1 back
  Color color = mix(look.belly, look.flank, smooth_step(0.08, 0.42, share));
  color = mix(color, look.back, smooth_step(0.55, 0.95, share));
  color = mix(color, look.tail, smooth_step(look.tail_from - 0.02, look.tail_from + 0.02, along));
  double wobble = std::sin(23 * along + 5) * std::sin(31 * up + 2);
  color = marked(look, color, along, share, wobble);
  // The edge of the gill cover, and the mouth.
  double gill = std::abs(std::hypot((along - 0.10) / 0.8, up * 0.62) - 0.125);
  if (along > 0.12) color = shaded(color, 1 - 0.28 * (1 - smooth_step(0.0, 0.008, gill)));
  if (along > 0.2) color = shaded(color, 1 - 0.30 * look.scales * scale_shade(along, up));
  if (along < 0.05) color = shaded(color, 1 - 0.5 * band(up, -0.012 - 0.1 * along, 0.004, 0.003));
  return color;
}

Color fin_color(const FishLook& look, double along, double up, double share) {
  Color color = mix(look.fins, look.tail, smooth_step(look.tail_from - 0.02, look.tail_from + 0.02, along));
  if (look.marked_fins && look.pattern == FishPattern::bars) color = marked(look, color, along, share, 0);
  // Rays: along the tail, up and back on the other fins.
  double across = along > 0.8 ? up / (0.25 + along - 0.8) * 46 : (along - 0.35 * std::abs(up)) * 95;
  return shaded(color, 0.93 + 0.13 * std::sin(2 * kPi * across));
}

Color eye_over(const FishForm& form, const FishLook& look, Color color, double along, double up) {
  double middle = 0.105 + 0.04 * form.snout, raised = 0.32 * fish_depth(form, middle / kFishBody);
  double r = std::hypot(along - middle, up - raised) / (look.eye / 2);
  color = mix(color, shaded(look.back, 0.5), 0.5 * (1 - smooth_step(1.0, 1.35, r)));
  color = mix(color, look.iris, 1 - smooth_step(0.92, 1.06, r));
  color = mix(color, {0.015f, 0.015f, 0.02f}, 1 - smooth_step(0.58, 0.68, r));
  double glint = std::hypot(along - middle + 0.12 * look.eye, up - raised - 0.14 * look.eye) / look.eye;
  return mix(color, {1, 1, 1}, 0.9 * (1 - smooth_step(0.06, 0.11, glint)));
}

Raster fish_picture(const FishForm& form, const FishLook& look) {
  int wide = look.pixels, high = static_cast<int>(std::lround(kSpan * look.pixels));
  Raster picture(wide, high, 3);
  for (int y = 0; y < high; ++y)
    for (int x = 0; x < wide; ++x) {
      double along = (x + 0.5) / wide, up = kSpan * (0.5 - (y + 0.5) / high);
      double half = fish_depth(form, std::min(along / kFishBody, 1.0));
      bool inside = along < kFishBody + 0.02 && std::abs(up) < half + 0.004;
      Color color = inside ? eye_over(form, look, body_color(form, look, along, up), along, up)
                           : fin_color(look, along, up, up > 0 ? 1 : 0);
      std::uint8_t* pixel = &picture.data[picture.index(x, y)];
      pixel[0] = to_byte(color.red), pixel[1] = to_byte(color.green), pixel[2] = to_byte(color.blue);
    }
  return picture;
}

}  // namespace

double fish_depth(const FishForm& form, double at) {
  double t = std::clamp(at, 0.0, 1.0), peak = form.deepest;
  double shape = 0;
  if (t < peak) {
    shape = std::pow(std::sin(0.5 * kPi * t / peak), 0.5 + 0.7 * form.snout);
  } else {
    double fall = (t - peak) / (1 - peak), ease = 0.5 + 0.5 * std::cos(kPi * std::min(1.0, 1.04 * fall));
    shape = form.peduncle + (1 - form.peduncle) * std::pow(ease, 0.85);
  }
  return 0.5 * form.depth * shape;
}

double dorsal_height(const FishForm& form, double at) {
  double t = (at - form.dorsal_from) / (0.75 - form.dorsal_from);
  if (t <= 0 || t >= 1) return 0;
  // Spiny in front, a soft lobe behind.
  return form.dorsal * (0.75 * std::pow(std::sin(kPi * std::pow(t, 0.6)), 0.5) +
                        0.45 * std::exp(-std::pow((t - 0.82) / 0.12, 2)));
}

double anal_height(const FishForm& form, double at) {
  double t = (at - 0.52) / 0.23;
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
  std::string name = fish_picture_name(form, look);
  auto draw = [name, form, look]() -> Result<std::vector<Picture>> {
    Result<std::string> bytes = png_text(fish_picture(form, look));
    if (!bytes) return bytes.errors();
    return std::vector<Picture>{{name, std::move(*bytes)}};
  };
  constexpr double kSecondsAPixel = 4e-7;
  double pixels = kSpan * look.pixels * look.pixels;
  return {{name}, std::move(draw), pixels, kSecondsAPixel * pixels};
}

}  // namespace frond
