#include "images/leaf.h"

#include <algorithm>
#include <cmath>

#include "images/leaf_parts.h"

namespace frond {

namespace {

struct Named {
  std::string_view name;
  LeafOutline outline;
};

const std::vector<Named>& table() {
  static const std::vector<Named> list = {
      {"birch", {{1, 0.70, 0.56, 0.56, 0.60, 0.58, 0.50}, 0.95, 22, 0.06, 0.20, false}},
      {"beech", {{1, 0.86, 0.72, 0.64, 0.64, 0.72, 0.80}, 0.92, 0, 0, 0.10, false}},
      {"oak",
       {{1, 0.94, 0.62, 0.80, 0.50, 0.70, 0.46, 0.58, 0.46, 0.44, 0.52, 0.50, 0.66, 0.74},
        0.95,
        0,
        0,
        0.10,
        false}},
      {"maple",
       {{1, 0.62, 0.66, 0.36, 0.56, 0.95, 0.60, 0.62, 0.36, 0.46, 0.66, 0.50, 0.34}, 1, 0, 0, 0.26, true}},
      {"ivy",
       {{1, 0.80, 0.56, 0.52, 0.70, 0.84, 0.62, 0.50, 0.56, 0.62, 0.48, 0.24}, 0.95, 0, 0, 0.28, true}},
      {"aspen", {{1, 0.84, 0.80, 0.82, 0.84, 0.82, 0.74}, 0.98, 16, 0.03, 0.36, false}},
      {"willow", {{1, 0.50, 0.28, 0.20, 0.175, 0.17, 0.19, 0.25, 0.44, 0.92}, 0.85, 0, 0, 0.06, false}},
      {"linden", {{1, 0.76, 0.76, 0.82, 0.88, 0.92, 0.88, 0.64}, 0.96, 24, 0.05, 0.26, false}},
      {"cherry", {{1, 0.72, 0.58, 0.54, 0.56, 0.62, 0.72}, 0.90, 26, 0.035, 0.14, false}},
      {"ginkgo", {{0.72, 0.90, 0.98, 1, 0.90, 0.62, 0.55, 0.62, 0.75}, 1.15, 0, 0, 0.34, true}},
  };
  return list;
}

}  // namespace

// Control points are joined by Catmull-Rom.
double leaf_radius(const LeafOutline& o, double angle) {
  double a = std::abs(angle);
  auto n = static_cast<int>(o.radii.size());
  if (n == 1) return o.radii[0];
  double x = std::min(a / kPi, 1.0) * (n - 1);
  int i = std::min(static_cast<int>(x), n - 2);
  double t = x - i;
  auto at = [&](int k) {
    return o.radii[static_cast<std::size_t>(k < 0 ? -k : k >= n ? 2 * (n - 1) - k : k)];
  };
  double p = at(i - 1), q = at(i), r = at(i + 1), s = at(i + 2);
  double value = q + 0.5 * t * (r - p + t * (2 * p - 5 * q + 4 * r - s + t * (3 * (q - r) + s - p)));
  if (o.teeth > 0 && o.tooth > 0) {
    // Teeth point forward, and there are none at the stalk.
    double k = a / kPi * o.teeth, saw = k - std::floor(k);
    value *= 1 + o.tooth * (saw < 0.3 ? saw / 0.3 : (1 - saw) / 0.7) * (1 - smooth_step(0.8, 1.0, a / kPi)) -
             0.5 * o.tooth;
  }
  return std::max(value, 0.02);
}

LeafFrame leaf_frame(const LeafOutline& o) {
  double tip = leaf_radius(o, 0), foot = leaf_radius(o, kPi), blade = 1 - o.stalk;
  double scale = blade / (tip + foot);
  return {o.stalk + foot * scale, scale};
}

LeafOutline leaf_outline(std::string_view name) {
  for (const Named& n : table())
    if (n.name == name) return n.outline;
  LeafOutline none;
  none.radii.clear();
  return none;
}

std::span<const std::string_view> leaf_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for (const Named& n : table()) list.push_back(n.name);
    return list;
  }();
  return names;
}

std::vector<LeafPlace> sprig_places(const Sprig& s) {
  std::vector<LeafPlace> places;
  double top = s.end_leaf ? 1 - s.length * (1 - s.shrink) : 0.92, low = 0.14;
  double end = s.end_leaf ? top - 0.35 * s.length : top;
  for (int i = 0; i < s.pairs; ++i) {
    double t = s.pairs > 1 ? static_cast<double>(i) / (s.pairs - 1) : 0.5,
           gap = (end - low) / std::max(s.pairs, 2);
    double size = s.length * (1 - s.shrink * t) * (0.82 + 0.18 * std::sin(kPi * std::min(1.0, t + 0.35)));
    for (int side : {1, -1}) {
      double y = low + (end - low) * t + (side < 0 ? 0.5 * gap * s.alternate : 0);
      places.push_back({Vec2(0, y), side * s.angle * (1 - 0.25 * t), size});
    }
  }
  if (s.end_leaf) places.push_back({Vec2(0, top), 0, 1 - top});
  return places;
}

PictureFrame picture_frame(const LeafImage& leaf) {
  std::vector<Vec2> rim = leaf_rim(leaf.outline, 64);
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

}  // namespace frond
