#include <algorithm>
#include <cmath>
#include <utility>

#include "core/linear.h"
#include "images/leaf_blade.h"

namespace frond {

namespace {

/// Known leaves, drawn by eye.
const std::vector<std::pair<std::string_view, LeafOutline>>& table() {
  // clang-format off
  constexpr auto kPinnate = VeinPattern::pinnate, kPalmate = VeinPattern::palmate;
  static const std::vector<std::pair<std::string_view, LeafOutline>> list = {
      // name    radii, from the tip to the stalk; width, teeth, tooth, stalk, venation
      {"birch", {{1, 0.70, 0.56, 0.56, 0.60, 0.58, 0.50}, 0.95, 22, 0.06, 0.20, {kPinnate, 7}}},
      {"beech",
       {{1, 0.86, 0.72, 0.64, 0.64, 0.72, 0.80}, 0.92, 0, 0, 0.10, {kPinnate, 8, 1, true, true, radians(47.0)}}},
      {"oak",
       {{1, 0.94, 0.62, 0.80, 0.50, 0.70, 0.46, 0.58, 0.46, 0.44, 0.52, 0.50, 0.66, 0.74}, 0.95, 0, 0, 0.10,
        {kPinnate, 5}}},
      {"maple",
       {{1, 0.80, 0.64, 0.72, 0.56, 0.44, 0.40, 0.46, 0.58, 0.74, 0.68, 0.84, 0.97, 0.80, 0.64, 0.70, 0.56,
         0.46, 0.42, 0.44, 0.50, 0.59, 0.54, 0.63, 0.72, 0.60, 0.50, 0.51, 0.42, 0.38, 0.36, 0.35, 0.34,
         0.33, 0.32, 0.30, 0.26}, 1, 0, 0, 0.26, {kPalmate, 8}}},
      {"ivy", {{1, 0.80, 0.56, 0.52, 0.70, 0.84, 0.62, 0.50, 0.56, 0.62, 0.48, 0.24}, 0.95, 0, 0, 0.28, {kPalmate, 6}}},
      {"aspen", {{1, 0.84, 0.80, 0.82, 0.84, 0.82, 0.74}, 0.98, 16, 0.03, 0.36, {kPinnate, 6}}},
      {"willow",
       {{1, 0.50, 0.28, 0.20, 0.175, 0.17, 0.19, 0.25, 0.44, 0.92}, 0.85, 0, 0, 0.06,
        {kPinnate, 17, 1, true, false, radians(50.0)}}},
      {"linden", {{1, 0.76, 0.76, 0.82, 0.88, 0.92, 0.88, 0.64}, 0.96, 24, 0.05, 0.26, {kPinnate, 7}}},
      {"cherry", {{1, 0.72, 0.58, 0.54, 0.56, 0.62, 0.72}, 0.90, 26, 0.035, 0.14, {kPinnate, 9}}},
      {"ginkgo",
       {{0.72, 0.90, 0.98, 1, 0.90, 0.62, 0.55, 0.62, 0.75}, 1.15, 0, 0, 0.34, {VeinPattern::dichotomous, 8}}},
  };
  // clang-format on
  return list;
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

/// Control points are joined by Catmull-Rom.
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
    if (k < kShortSide) high = 1;  // the leaf's tip is one, too
    value *= 1 + o.tooth * high * (1 - smooth_step(0.8, 1.0, a / kPi)) - 0.5 * o.tooth;
  }
  return std::max(value, 0.02 * std::max(*std::ranges::max_element(o.radii), 1e-6));
}

namespace {

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

constexpr int kAngles = 2048;  // of the half of a rim, at which radii are kept
constexpr int kWaySteps = 8;   // of a way that is looked at

}  // namespace

Lamina::Lamina(const LeafOutline& o)
    : middle_(leaf_frame(o).middle),
      scale_(leaf_frame(o).scale),
      width_(o.width),
      foot_(0, static_cast<float>(o.stalk)) {
  for (int i = 0; i <= kAngles; ++i) {
    double a = kPi * i / kAngles, r = leaf_radius(o, a);
    radii_.push_back(static_cast<float>(r));
    auto y = static_cast<float>(middle_ + r * scale_ * std::cos(a));
    wide_ = std::max(wide_, static_cast<float>(r * scale_ * width_ * std::sin(a)));
    low_ = i == 0 ? y : std::min(low_, y);
    high_ = std::max(high_, y);
  }
}

double Lamina::radius(double angle) const {
  double x = std::min(std::abs(angle) / kPi, 1.0) * kAngles;
  int i = std::min(static_cast<int>(x), kAngles - 1);
  return std::lerp(double{radii_[i]}, double{radii_[i + 1]}, x - i);
}

double Lamina::out(Vec2 p) const {
  double x = p.x / width_, y = p.y - middle_;
  return std::sqrt(x * x + y * y) / (radius(std::atan2(x, y)) * scale_);
}

bool Lamina::holds_way(Vec2 from, Vec2 to) const {
  for (int i = 1; i <= kWaySteps; ++i)
    if (!holds(glm::mix(from, to, static_cast<float>(i) / kWaySteps))) return false;
  return true;
}

Vec2 Lamina::at(double angle, double share) const {
  double r = radius(angle) * scale_ * share;
  return {static_cast<float>(r * std::sin(angle) * width_),
          static_cast<float>(middle_ + r * std::cos(angle))};
}

std::vector<RimTip> rim_tips(const LeafOutline& outline, double least) {
  constexpr int kFine = 720;
  std::vector<double> r;
  for (int i = 0; i <= kFine; ++i) r.push_back(leaf_radius(outline, kPi * i / kFine));
  // The deepest notch on one side of a tip, up to where the rim is farther out than the tip. What is far away
  // belongs to the outline at large.
  auto notch = [&](int tip, int step) {
    constexpr int kFar = 115;  // of kFine: half a radian
    double deepest = r[tip];
    for (int i = tip + step; std::abs(i - tip) <= kFar && i >= 0 && i <= kFine && r[i] <= r[tip]; i += step)
      deepest = std::min(deepest, r[i]);
    return deepest;
  };
  std::vector<RimTip> tips;
  for (int i = kFine / 40; i < kFine - kFine / 40; ++i) {
    if (r[i] <= r[i - 1] || r[i] < r[i + 1]) continue;
    double prominence = r[i] - std::max(notch(i, -1), notch(i, 1));
    if (prominence >= least) tips.push_back({kPi * i / kFine, r[i], prominence});
  }
  return tips;
}

}  // namespace frond
