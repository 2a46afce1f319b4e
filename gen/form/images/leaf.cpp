#include "images/leaf.h"

#include <algorithm>
#include <cmath>

#include "core/linear.h"
#include "core/parallel.h"
#include "images/leaf_blade.h"
#include "images/leaf_photo.h"
#include "images/leaf_relief.h"
#include "images/tiling_noise.h"
#include "images/vein_field.h"

namespace frond {

namespace {

using Rgb = glm::dvec3;

constexpr int kSamples = 3;  // a pixel, each way
constexpr Rgb kBrown{0.36, 0.20, 0.09};
constexpr double kFinestNet = 0.022;  // distance of the veins of the finest net, in the leaf's unit
constexpr double kLeafStalk = 0.018, kSprigStalk = 0.012;  // half their widths, shares of leaf and sprig

Rgb rgb(const Color& c) { return {c.red, c.green, c.blue}; }

class Blade {
 public:
  /// `finest` and `largest`: sides of the pixels that it is drawn with, in the leaf's unit.
  Blade(const LeafImage& leaf, double finest, double largest, Seed seed)
      : leaf_(leaf), o_(leaf.outline), shape_(leaf.outline), seed_(seed) {
    constexpr double kAreole = 3;  // pixels: no net is finer
    if (!leaf.photo)
      veins_ = VeinField(
          grow_veins(o_, std::max(kFinestNet / std::max(1.0, o_.venation.density), kAreole * finest),
                     seed.child("veins")),
          largest);
  }

  /// Whether the leaf or its stalk covers a point of its own plane, one unit long.
  bool covers(Vec2 p) const {
    if (p.y < std::min(-0.01f, shape_.low()) || p.y > shape_.high() || std::abs(p.x) > shape_.wide())
      return on_stalk(p);
    return on_stalk(p) || shape_.holds(p);
  }

  /// The colour there; it goes on beyond the rim. `pixel` is the side of one in the leaf's unit.
  Rgb color(Vec2 p, int index, double pixel) const {
    double away = shape_.out(p);
    if (leaf_.photo) return dried(photographed(p, pixel), p, away, seed_.child(index), 0);
    if (away > 1 && on_stalk(p)) return glm::mix(rgb(leaf_.veins), rgb(leaf_.color), 0.3) * 0.9;
    VeinSight vein = veins_.at(p, pixel);
    Seed own = seed_.child(index);
    // Along a leaf go 5 blotches.
    double blotch = tiling_fractal(p.x * 5 + 8, p.y * 5, 64, 64, 4, 0.6, own.child("blotch"));
    // Between the larger veins the blade bulges into the light.
    Rgb color = rgb(leaf_.color) * (0.80 + 0.24 * std::min(away, 1.0)) * (0.90 + 0.13 * vein.bulge);
    color *= Rgb(1) + Rgb(0.9, 0.5, 0.3) * (leaf_.spots * blotch);
    color = glm::mix(color, rgb(leaf_.rim), 0.55 * smooth_step(0.80, 1.0, away));
    color = dried(color, p, away, own, blotch);
    return glm::mix(color, rgb(leaf_.veins), 0.78 * std::min(vein.line, 1.0));
  }

  /// How high it is raised: veins are sunk in, and between the larger ones the blade bulges. -1..1
  double height(Vec2 p, double pixel) const {
    if (leaf_.photo) return 0;
    VeinSight vein = veins_.at(p, pixel);
    return vein.bulge - std::min(vein.line, 1.0);
  }

 private:
  /// The photograph's colour. The leaf's stalk may be longer than that of the photograph, and its blade
  /// wider.
  Rgb photographed(Vec2 p, double pixel) const {
    const LeafPhoto& photo = *leaf_.photo;
    double stalk = photo.outline.stalk, y = p.y - o_.stalk;
    y = y > 0 ? stalk + y / shape_.scale() : o_.stalk > 0 ? p.y * stalk / o_.stalk : y;
    Vec3 light = photo.at(Vec2(p.x / (o_.width * shape_.scale()), y), pixel);
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

  const LeafImage& leaf_;
  const LeafOutline& o_;
  Lamina shape_;
  Seed seed_;
  VeinField veins_;
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
    Vec2 on(d.x * c - d.y * s, d.x * s + d.y * c);
    // Leaflets of the two sides mirror each other.
    return place.turn < 0 && !leaf.photo ? Vec2(-on.x, on.y) : on;
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

  double height(Vec2 p) const {
    for (std::size_t i = places.size(); i-- > 0;)
      if (Vec2 q = on_leaf(p, places[i]); blade.covers(q)) return blade.height(q, pixel / places[i].size);
    return blade.height(on_leaf(p, places.back()), pixel / places.back().size);
  }
};

/// What a picture of a leaf is drawn with.
struct LeafSheet {
  PictureFrame frame;
  double tall;
  int width, height;
  std::vector<LeafPlace> places;
  Blade blade;

  LeafSheet(const LeafImage& leaf, int pixels, Seed seed)
      : frame(picture_frame(leaf)),
        tall(frame.high - frame.low),
        width(std::max(8, static_cast<int>(std::lround(2 * frame.half / tall * pixels)))),
        height(pixels),
        places(places_of(leaf)),
        blade(leaf, pixel() / std::ranges::max(places, {}, &LeafPlace::size).size,
              pixel() / std::ranges::min(places, {}, &LeafPlace::size).size, seed.child("leaf")) {}

  double pixel() const { return tall / height; }
  LeafPainter painter(const LeafImage& leaf) const { return {leaf, blade, places, pixel()}; }

  Vec2 point(double x, double y) const {
    return Vec2((x / width * 2 - 1) * frame.half, frame.high - y / height * tall);
  }

  static std::vector<LeafPlace> places_of(const LeafImage& leaf) {
    std::vector<LeafPlace> list = leaf.sprig ? sprig_places(leaf.sprigs) : std::vector<LeafPlace>{{}};
    if (list.empty()) list.push_back({});
    return list;
  }
};

}  // namespace

Raster leaf_picture(const LeafImage& leaf, int height, Seed seed) {
  LeafSheet sheet(leaf, height, seed);
  LeafPainter painter = sheet.painter(leaf);
  Raster raster(sheet.width, height, 4);
  parallel_for(static_cast<std::size_t>(height), [&](std::size_t row) {
    int y = static_cast<int>(row);
    for (int x = 0; x < sheet.width; ++x) {
      int covered = 0;
      Vec2 middle = sheet.point(x + 0.5, y + 0.5), inside = middle;
      for (int k = 0; k < kSamples * kSamples; ++k) {
        Vec2 p = sheet.point(x + (k % kSamples + 0.5) / kSamples, y + (k / kSamples + 0.5) / kSamples);
        if (!painter.covers(p)) continue;
        if (covered++ == 0) inside = p;
      }
      Rgb color = painter.color(covered == kSamples * kSamples ? middle : inside);
      for (int c = 0; c < 3; ++c) raster.data[raster.index(x, y, c)] = to_byte(color[c]);
      raster.data[raster.index(x, y, 3)] = to_byte(static_cast<double>(covered) / (kSamples * kSamples));
    }
  });
  return raster;
}

Grid leaf_heights(const LeafImage& leaf, int height, Seed seed) {
  LeafSheet sheet(leaf, height, seed);
  LeafPainter painter = sheet.painter(leaf);
  Grid heights(sheet.width, height);
  parallel_for(static_cast<std::size_t>(height), [&](std::size_t row) {
    int y = static_cast<int>(row);
    for (int x = 0; x < sheet.width; ++x)
      heights.at(x, y) = static_cast<float>(painter.height(sheet.point(x + 0.5, y + 0.5)));
  });
  return heights;
}

}  // namespace frond
