#include "images/leaf.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/linear.h"
#include "core/parallel.h"
#include "images/leaf_photo.h"
#include "images/tiling_noise.h"

namespace frond {

namespace {

/// Known leaves, drawn by eye.
const std::vector<std::pair<std::string_view, LeafOutline>>& table() {
  // clang-format off
  static const std::vector<std::pair<std::string_view, LeafOutline>> list = {
      // name    radii, from the tip to the stalk; width, teeth, tooth, stalk, palmate
      {"birch", {{1, 0.70, 0.56, 0.56, 0.60, 0.58, 0.50}, 0.95, 22, 0.06, 0.20, false}},
      {"beech", {{1, 0.86, 0.72, 0.64, 0.64, 0.72, 0.80}, 0.92, 0, 0, 0.10, false}},
      {"oak",
       {{1, 0.94, 0.62, 0.80, 0.50, 0.70, 0.46, 0.58, 0.46, 0.44, 0.52, 0.50, 0.66, 0.74}, 0.95, 0, 0, 0.10, false}},
      {"maple",
       {{1, 0.80, 0.64, 0.72, 0.56, 0.44, 0.40, 0.46, 0.58, 0.74, 0.68, 0.84, 0.97, 0.80, 0.64, 0.70, 0.56,
         0.46, 0.42, 0.44, 0.50, 0.59, 0.54, 0.63, 0.72, 0.60, 0.50, 0.51, 0.42, 0.38, 0.36, 0.35, 0.34,
         0.33, 0.32, 0.30, 0.26}, 1, 0, 0, 0.26, true}},
      {"ivy", {{1, 0.80, 0.56, 0.52, 0.70, 0.84, 0.62, 0.50, 0.56, 0.62, 0.48, 0.24}, 0.95, 0, 0, 0.28, true}},
      {"aspen", {{1, 0.84, 0.80, 0.82, 0.84, 0.82, 0.74}, 0.98, 16, 0.03, 0.36, false}},
      {"willow", {{1, 0.50, 0.28, 0.20, 0.175, 0.17, 0.19, 0.25, 0.44, 0.92}, 0.85, 0, 0, 0.06, false}},
      {"linden", {{1, 0.76, 0.76, 0.82, 0.88, 0.92, 0.88, 0.64}, 0.96, 24, 0.05, 0.26, false}},
      {"cherry", {{1, 0.72, 0.58, 0.54, 0.56, 0.62, 0.72}, 0.90, 26, 0.035, 0.14, false}},
      {"ginkgo", {{0.72, 0.90, 0.98, 1, 0.90, 0.62, 0.55, 0.62, 0.75}, 1.15, 0, 0, 0.34, true}},
  };
  // clang-format on
  return list;
}

/// Radius of the blade at an angle from the tip, -pi..pi, in the outline's own unit. Control points are
/// joined by Catmull-Rom.
double leaf_radius(const LeafOutline& o, double angle) {
  double a = std::abs(angle);
  auto n = static_cast<int>(o.radii.size());
  if (n == 1) return o.radii[0];
  double x = std::min(a / kPi, 1.0) * (n - 1);
  int i = std::min(static_cast<int>(x), n - 2);
  double t = x - i;
  auto at = [&](int k) { return o.radii[k < 0 ? -k : k >= n ? 2 * (n - 1) - k : k]; };
  double p = at(i - 1), q = at(i), r = at(i + 1), s = at(i + 2);
  double value = q + 0.5 * t * (r - p + t * (2 * p - 5 * q + 4 * r - s + t * (3 * (q - r) + s - p)));
  if (o.teeth > 0 && o.tooth > 0) {
    // Teeth point forward, and there are none at the stalk.
    constexpr double kShortSide = 0.3, kLongSide = 0.7;  // of a tooth, as shares of it
    double k = a / kPi * o.teeth, saw = k - std::floor(k);
    double high = saw < kShortSide ? saw / kShortSide : (1 - saw) / kLongSide;
    value *= 1 + o.tooth * high * (1 - smooth_step(0.8, 1.0, a / kPi)) - 0.5 * o.tooth;
  }
  return std::max(value, 0.02);
}

constexpr int kBoundPoints = 64;  // of the rim, that bounds are taken from

/// How a blade lies in the unit of its leaf: where on the stalk's line the middle of its circle is, and what
/// a radius of 1 is there.
struct LeafFrame {
  double middle, scale;
};

LeafFrame leaf_frame(const LeafOutline& o) {
  double tip = leaf_radius(o, 0), foot = leaf_radius(o, kPi), blade = 1 - o.stalk;
  double scale = blade / (tip + foot);
  return {o.stalk + foot * scale, scale};
}

}  // namespace

LeafOutline leaf_outline(std::string_view name) {
  for (const auto& [known, outline] : table())
    if (known == name) return outline;
  LeafOutline none;
  none.radii.clear();
  return none;
}

std::span<const std::string_view> leaf_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for (const auto& [known, outline] : table()) list.push_back(known);
    return list;
  }();
  return names;
}

std::vector<LeafPlace> sprig_places(const Sprig& s) {
  constexpr double kLowestLeaf = 0.14, kHighestLeaf = 0.92;  // of the stalk, where no leaf is at its end
  constexpr double kBelowEnd = 0.35;  // of a leaf's length: from the last pair to the end leaf
  constexpr double kCloser = 0.25;    // share by which leaves at the tip lean more forward
  std::vector<LeafPlace> places;
  double top = s.end_leaf ? 1 - s.length * (1 - s.shrink) : kHighestLeaf, low = kLowestLeaf;
  double end = s.end_leaf ? top - kBelowEnd * s.length : top;
  for (int i = 0; i < s.pairs; ++i) {
    double t = s.pairs > 1 ? static_cast<double>(i) / (s.pairs - 1) : 0.5,
           gap = (end - low) / std::max(s.pairs, 2);
    // The longest is a little above the foot.
    double size = s.length * (1 - s.shrink * t) * (0.82 + 0.18 * std::sin(kPi * std::min(1.0, t + 0.35)));
    for (int side : {1, -1}) {
      double y = low + (end - low) * t + (side < 0 ? 0.5 * gap * s.alternate : 0);
      places.push_back({Vec2(0, y), side * s.angle * (1 - kCloser * t), size});
    }
  }
  if (s.end_leaf) places.push_back({Vec2(0, top), 0, 1 - top});
  return places;
}

PictureFrame picture_frame(const LeafImage& leaf) {
  std::vector<Vec2> rim = leaf_rim(leaf.outline, kBoundPoints);
  std::vector<LeafPlace> places = leaf.sprig ? sprig_places(leaf.sprigs) : std::vector<LeafPlace>{{}};
  PictureFrame frame{0.02, 0, leaf.sprig ? 0.0 : 1.0};
  for (const LeafPlace& p : places) {
    double c = std::cos(p.turn), s = std::sin(p.turn);
    for (Vec2 q : rim)
      for (double x : {static_cast<double>(q.x), -static_cast<double>(q.x)}) {
        double y = p.foot.y + p.size * (q.y * c - x * s);
        frame.half = std::max(frame.half, std::abs(p.foot.x + p.size * (x * c + q.y * s)));
        frame.low = std::min(frame.low, y);
        frame.high = std::max(frame.high, y);
      }
  }
  frame.half *= 1.02;
  // The foot and the tip of a leaf touch the edges; whatever goes farther keeps a little off them.
  double edge = 0.02 * (frame.high - frame.low);
  if (leaf.sprig || frame.low < 0) frame.low -= edge;
  if (leaf.sprig || frame.high > 1) frame.high += edge;
  return frame;
}

double leaf_middle(const LeafOutline& outline) { return leaf_frame(outline).middle; }

std::vector<Vec2> leaf_rim(const LeafOutline& outline, int points) {
  LeafFrame f = leaf_frame(outline);
  constexpr int kFine = 160;
  std::vector<Vec2> rim;
  for (int i = 0; i <= kFine; ++i) {
    double a = kPi * i / kFine, r = leaf_radius(outline, a) * f.scale;
    rim.emplace_back(i == 0 || i == kFine ? 0.0 : r * std::sin(a) * outline.width,
                     f.middle + r * std::cos(a));
  }
  // The point that matters least, by the area of its triangle, goes first (Visvalingam and Whyatt 1993).
  auto count = static_cast<std::size_t>(std::max(points, 3));
  while (rim.size() > count) {
    std::size_t least = 1;
    float smallest = 1e9f;
    for (std::size_t i = 1; i + 1 < rim.size(); ++i) {
      Vec2 a = rim[i] - rim[i - 1], b = rim[i + 1] - rim[i - 1];
      float area = std::abs(a.x * b.y - a.y * b.x);
      if (area < smallest) smallest = area, least = i;
    }
    rim.erase(rim.begin() + static_cast<std::ptrdiff_t>(least));
  }
  return rim;
}

namespace {

using Rgb = glm::dvec3;

constexpr int kSamples = 3;  // a pixel, each way
constexpr Rgb kBrown{0.36, 0.20, 0.09};
constexpr double kLeafStalk = 0.018, kSprigStalk = 0.012;  // half their widths, shares of leaf and sprig

/// The veins of a blade, by eye. Widths are half of a vein's at its foot, as shares of the leaf's length.
struct Venation {
  double midrib = 0.013, lobe = 0.010;              ///< widths of main veins
  double side = 0.006, lobe_side = 0.0055;          ///< widths of side veins of the midrib, of those to lobes
  double taper = 0.8;                               ///< share of its width that a main vein loses to its end
  double side_shows = 0.8, lobe_side_shows = 0.7;   ///< strength of side veins as a share of a main vein's
  int pairs = 9;                                    ///< of side veins on a midrib
  double slope = 0.75;                              ///< rise of a side vein over its way outward, at first
  double side_shift = 0.15, lobe_side_shift = 0.4;  ///< of a gap, between the side veins of the two halves
};
constexpr Venation kVeins;

Rgb rgb(const Color& c) { return {c.red, c.green, c.blue}; }

/// How strongly a line shows: 1 on the line .. 0 away from it. A line finer than a pixel is drawn as wide as
/// one and fainter, or it would break up into dots.
double line(double away, double width, double pixel) {
  double drawn = std::max(width, 0.8 * pixel);
  return drawn > 0 ? std::sqrt(width / drawn) * smooth_step(0.0, 1.0, 1.6 - away / drawn) : 0;
}

/// How strongly a straight vein shows at `p`, as line() does; the vein tapers toward its end.
double vein(Vec2 p, Vec2 from, Vec2 to, double width, double pixel) {
  Vec2 segment = to - from, off = p - from;
  double t = std::clamp<double>(glm::dot(off, segment) / glm::dot(segment, segment), 0, 1);
  return line(glm::length(off - segment * static_cast<float>(t)), width * (1 - kVeins.taper * t), pixel);
}

class Blade {
 public:
  Blade(const LeafImage& leaf, Seed seed) : leaf_(leaf), o_(leaf.outline), seed_(seed) {
    LeafFrame f = leaf_frame(o_);
    middle_ = f.middle;
    scale_ = f.scale;
    foot_ = Vec2(0, o_.stalk);
    for (Vec2 p : leaf_rim(o_, kBoundPoints))
      wide_ = std::max(wide_, 1.03f * p.x), high_ = std::max(high_, 1.01f * p.y);
    if (!o_.palmate) return;
    // Main veins go to the lobes: where the rim is farthest out.
    auto n = static_cast<int>(o_.radii.size());
    for (int i = 1; i + 1 < n; ++i) {
      auto at = [&](int k) { return o_.radii[k]; };
      bool lobe = true;  // and no tooth beside one
      int round = std::max(1, n / 9);
      for (int k = std::max(0, i - round); k <= std::min(n - 1, i + round); ++k)
        lobe = lobe && at(i) >= at(k);
      if (!lobe) continue;
      double a = kPi * i / (n - 1), r = at(i) * scale_;
      lobes_.emplace_back(r * std::sin(a) * o_.width, middle_ + r * std::cos(a));
    }
  }

  /// Whether the leaf or its stalk covers a point of its own plane, one unit long.
  bool covers(Vec2 p) const {
    if (p.y < -0.01f || p.y > high_ || std::abs(p.x) > wide_) return false;
    return on_stalk(p) || out(p) <= 1;
  }

  /// The colour there; it goes on beyond the rim. `pixel` is the side of one in the leaf's unit.
  Rgb color(Vec2 p, int index, double pixel) const {
    double away = out(p);
    if (leaf_.photo) return dried(photographed(p, pixel), p, away, seed_.child(index), 0);
    if (away > 1 && on_stalk(p)) return glm::mix(rgb(leaf_.veins), rgb(leaf_.color), 0.3) * 0.9;
    double strength = veins(p, pixel);
    Seed own = seed_.child(index);
    // Along a leaf go 5 blotches and 46 cells of the net of the finest veins.
    double blotch = tiling_fractal(p.x * 5 + 8, p.y * 5, 64, 64, 4, 0.6, own.child("blotch"));
    Cells net = tiling_cells(p.x * 46 + 64, p.y * 46, 512, 512, own.child("net"));
    double mesh = smooth_step(0.0, 0.16, net.second - net.nearest);
    Rgb color = rgb(leaf_.color) * (0.80 + 0.30 * std::min(away, 1.0)) * (0.93 + 0.07 * mesh);
    color *= Rgb(1) + Rgb(0.9, 0.5, 0.3) * (leaf_.spots * blotch);
    color = glm::mix(color, rgb(leaf_.rim), 0.55 * smooth_step(0.80, 1.0, away));
    color = dried(color, p, away, own, blotch);
    // Beside a vein the blade bulges: light on one side, dark on the other.
    color *= 1 - 0.14 * smooth_step(0.02, 0.35, strength) * (1 - smooth_step(0.35, 1.0, strength));
    return glm::mix(color, rgb(leaf_.veins), 0.75 * smooth_step(0.3, 1.0, strength));
  }

 private:
  /// The photograph's colour. The leaf's stalk may be longer than that of the photograph, and its blade
  /// wider.
  Rgb photographed(Vec2 p, double pixel) const {
    const LeafPhoto& photo = *leaf_.photo;
    double stalk = photo.outline.stalk, y = p.y - o_.stalk;
    y = y > 0 ? stalk + y / scale_ : o_.stalk > 0 ? p.y * stalk / o_.stalk : y;
    Vec3 light = photo.at(Vec2(p.x / (o_.width * scale_), y), pixel);
    Color seen = srgb(glm::clamp(light * linear(leaf_.color) / glm::max(linear(photo.mean), Vec3(1e-3f)),
                                 Vec3(0), Vec3(1)));
    return glm::max(rgb(seen), Rgb(1.0 / 255));  // black is where no leaf is
  }

  /// A colour with the brown of age.
  Rgb dried(Rgb color, Vec2 p, double away, Seed own, double blotch) const {
    if (leaf_.age <= 0) return color;
    double rough = tiling_fractal(p.x * 7 + 8, p.y * 7, 64, 64, 5, 0.6, own.child("age"));
    double brown = smooth_step(0.12, 0.34, 1.1 * leaf_.age + 0.9 * (std::min(away, 1.0) - 1) + 0.4 * rough);
    return glm::mix(color, kBrown * (1 + 0.5 * blotch), 0.85 * brown);
  }

  bool on_stalk(Vec2 p) const { return p.y <= o_.stalk + 0.03 && p.y >= -0.01 && std::abs(p.x) < kLeafStalk; }

  /// How far from the middle of the blade, 1 on its rim.
  double out(Vec2 p) const {
    double x = p.x / o_.width, y = p.y - middle_;
    return std::hypot(x, y) / (leaf_radius(o_, std::atan2(x, y)) * scale_);
  }

  /// 1 on a vein .. 0 away from it.
  double veins(Vec2 p, double pixel) const {
    double strongest = vein(p, foot_, Vec2(0, 1), kVeins.midrib, pixel);
    if (o_.palmate) {
      for (Vec2 lobe : lobes_)
        for (float side : {1.0f, -1.0f})
          strongest = std::max(strongest, vein(p, foot_, Vec2(lobe.x * side, lobe.y), kVeins.lobe, pixel));
      return std::max(strongest, kVeins.lobe_side_shows * lobe_veins(p, pixel));
    }
    return std::max(strongest, kVeins.side_shows * side_veins(p, pixel));
  }

  /// Side veins that leave the midrib forward and bend to the tip.
  double side_veins(Vec2 p, double pixel) const {
    double x = std::abs(p.x), along = (p.y - kVeins.slope * x - 0.5 * x * x - o_.stalk) / (1 - o_.stalk);
    if (along < 0.02) return 0;  // none so near the foot
    double k = along * kVeins.pairs + (p.x > 0 ? kVeins.side_shift : 0);
    double d = std::abs(k - std::floor(k) - 0.5) / kVeins.pairs;
    return line(d, kVeins.side * (1 - std::min(1.0, 1.6 * x)), pixel / (1 - o_.stalk));
  }

  /// Side veins of that main vein which is nearest by its direction, as the others hide behind it.
  double lobe_veins(Vec2 p, double pixel) const {
    Vec2 off = Vec2(std::abs(p.x), p.y) - foot_, main = Vec2(0, 1) - foot_;
    for (Vec2 lobe : lobes_)
      if (Vec2 other = lobe - foot_;
          glm::dot(off, other) * glm::length(main) > glm::dot(off, main) * glm::length(other))
        main = other;
    float length = glm::length(main), along = glm::dot(off, main) / length;
    double side = (off.x * main.y - off.y * main.x) / length, away = std::abs(side);
    if (along < 0.02f || along > length) return 0;
    double count = 2 + 7 * length,
           k = (along - 0.9 * away) / length * count + (side > 0 ? kVeins.lobe_side_shift : 0);
    return line(0.74 * length * std::abs(k - std::floor(k) - 0.5) / count,
                kVeins.lobe_side * (1 - std::min(1.0, 3 * away)), pixel);
  }

  const LeafImage& leaf_;
  const LeafOutline& o_;
  Seed seed_;
  double middle_ = 0.5, scale_ = 1;
  Vec2 foot_{0};
  float wide_ = 0.02f, high_ = 1.01f;
  std::vector<Vec2> lobes_;
};

/// A leaf or a sprig of them in the plane of its picture.
struct LeafPainter {
  const LeafImage& leaf;
  const Blade& blade;
  const std::vector<LeafPlace>& places;
  double pixel = 0;

  Vec2 on_leaf(Vec2 p, const LeafPlace& place) const {
    Vec2 d = (p - place.foot) / static_cast<float>(place.size);
    auto c = static_cast<float>(std::cos(place.turn)), s = static_cast<float>(std::sin(place.turn));
    return {d.x * c - d.y * s, d.x * s + d.y * c};
  }

  bool on_stalk(Vec2 p) const {
    return leaf.sprig && std::abs(p.x) < kSprigStalk && p.y > -0.01 && p.y < places.back().foot.y + 0.02;
  }

  bool covers(Vec2 p) const {
    for (const LeafPlace& place : places)
      if (blade.covers(on_leaf(p, place))) return true;
    return on_stalk(p);
  }

  /// The colour of the topmost leaf at a place, or else of the stalk.
  Rgb color(Vec2 p) const {
    for (std::size_t i = places.size(); i-- > 0;)
      if (Vec2 q = on_leaf(p, places[i]); blade.covers(q))
        return blade.color(q, static_cast<int>(i), pixel / places[i].size);
    if (on_stalk(p)) return glm::mix(rgb(leaf.veins), rgb(leaf.color), 0.4) * 0.85;
    return blade.color(on_leaf(p, places.back()), 0, pixel / places.back().size);
  }
};

}  // namespace

Raster leaf_picture(const LeafImage& leaf, int height, Seed seed) {
  PictureFrame frame = picture_frame(leaf);
  double tall = frame.high - frame.low;
  int width = std::max(8, static_cast<int>(std::lround(2 * frame.half / tall * height)));
  std::vector<LeafPlace> places = leaf.sprig ? sprig_places(leaf.sprigs) : std::vector<LeafPlace>{{}};
  if (places.empty()) places.push_back({});
  Blade blade(leaf, seed.child("leaf"));
  LeafPainter painter{leaf, blade, places, tall / height};
  Raster raster(width, height, 4);
  parallel_for(static_cast<std::size_t>(height), [&](std::size_t row) {
    int y = static_cast<int>(row);
    for (int x = 0; x < width; ++x) {
      auto point = [&](double px, double py) {
        return Vec2((px / width * 2 - 1) * frame.half, frame.high - py / height * tall);
      };
      int covered = 0;
      Vec2 inside = point(x + 0.5, y + 0.5);
      for (int k = 0; k < kSamples * kSamples; ++k) {
        Vec2 p = point(x + (k % kSamples + 0.5) / kSamples, y + (k / kSamples + 0.5) / kSamples);
        if (!painter.covers(p)) continue;
        if (covered++ == 0) inside = p;
      }
      Rgb color = painter.color(covered == kSamples * kSamples ? point(x + 0.5, y + 0.5) : inside);
      for (int c = 0; c < 3; ++c) raster.data[raster.index(x, y, c)] = to_byte(color[c]);
      raster.data[raster.index(x, y, 3)] = to_byte(static_cast<double>(covered) / (kSamples * kSamples));
    }
  });
  return raster;
}

}  // namespace frond
