#include <algorithm>
#include <cmath>

#include "organisms/school/swimmer_shape.h"

namespace frond {

namespace {

constexpr int kRings = 32, kRound = 18;  // of the body
constexpr int kFinSteps = 16;            // along a fin
constexpr int kSpines = 11;              // of a fin with spines
constexpr double kTailOverlap = 0.03;    // of the tail's root in the body
constexpr double kRoundness = 0.92;      // power of the height: 1 makes the rings ellipses

/// Half the thickness of the body, in lengths of the fish, at a position 0..1 from the nose.
double fish_thickness(const FishForm& form, double at) {
  constexpr double kGills = 0.25;                     // where they end, as a share of the body
  constexpr double kThickness = 1.05, kThins = 0.75;  // of FishForm::width: at the gills, less at the tail
  constexpr double kCloses = 0.86;  // from where it narrows to the edge that the tail stands on
  // Behind the gills the body thins sooner than it narrows.
  double thin = at < kGills ? kThickness : kThickness - kThins * smooth_step(kGills, 1.0, at);
  double end = std::max(0.0, (at - kCloses) / (1 - kCloses));
  return fish_depth(form, at) * form.width * thin * std::sqrt(1 - 0.99 * end * end);
}

void add_body(Surface& mesh, const FishForm& form) {
  auto first = static_cast<std::uint32_t>(mesh.position.size());
  for (int i = 0; i <= kRings; ++i) {
    double t = static_cast<double>(i) / kRings, s = t * t * (1.6 - 0.6 * t);  // closer at the nose
    double along = kFishBody * s, thick = fish_thickness(form, s);
    for (int k = 0; k < kRound; ++k) {
      double turn = 2 * kPi * k / kRound, c = std::cos(turn), z = std::sin(turn);
      double side = z < 0 ? -1 : 1, out = thick * c,
             up = side * fish_height(form, s, side) * std::pow(std::abs(z), kRoundness);
      mesh.position.push_back(swimmer_place(along, up, out));
      mesh.uv.push_back(fish_uv(along, up));
    }
  }
  for (std::uint32_t i = 0; i < kRings; ++i)
    for (std::uint32_t k = 0; k < kRound; ++k) {
      std::uint32_t a = first + i * kRound + k, b = first + i * kRound + (k + 1) % kRound;
      if (i > 0) mesh.triangle.push_back({a, b, a + kRound});
      mesh.triangle.push_back({b, b + kRound, a + kRound});
    }
}

/// The eyes, which stand out from the head as domes.
void add_eyes(Surface& mesh, const FishForm& form, double width) {
  constexpr double kRim = 0.56, kStandsOut = 0.2, kSunk = 0.96;  // of its width; of the head's thickness
  if (width <= 0) return;
  const Vec2 eye = fish_eye(form);
  for (double side : {-1.0, 1.0}) {
    auto flat = [=](double t, double r) {
      double reach = kRim * width * r, turn = side * 2 * kPi * t;
      return std::pair(static_cast<double>(eye.x) + reach * std::cos(turn),
                       static_cast<double>(eye.y) + reach * std::sin(turn));
    };
    auto at = [&](double t, double r) {
      auto [along, up] = flat(t, r);
      double s = std::max(0.0, along / kFishBody),
             half = std::max(fish_height(form, s, up < 0 ? -1 : 1), 1e-6);
      double z = std::pow(std::min(1.0, std::abs(up) / half), 1 / kRoundness);
      double skin = fish_thickness(form, s) * std::sqrt(1 - z * z);
      return swimmer_place(along, up, side * (kSunk * skin + kStandsOut * width * (1 - r * r)));
    };
    add_sheet(mesh, 12, 4, at,
              [&](double t, double r) { return fish_uv(flat(t, r).first, flat(t, r).second); });
  }
}

/// How far the tail reaches back at a height, -1..1 of half its depth, as a share of its length. Hollow tails
/// reach from the first number in the middle to 1 at the corners, a round one the other way.
double tail_reach(TailShape shape, double v) {
  double a = std::abs(v);
  switch (shape) {
    case TailShape::forked:
      return 0.45 + 0.55 * std::pow(a, 1.2);
    case TailShape::lunate:
      return 0.22 + 0.78 * std::pow(a, 1.9);
    case TailShape::round:
      return 0.55 + 0.45 * std::sqrt(std::max(0.0, 1 - a * a));
    case TailShape::square:
      return 0.92;
    case TailShape::shark:  // the upper lobe to the end, the lower one half as far
      return v > 0 ? 0.3 + 0.7 * std::pow(a, 1.3) : 0.3 + 0.25 * std::pow(a, 1.3);
  }
  return 1;
}

/// A fin of a pair at the sides. Its root is at a share of the fish's length from the nose, up and out by
/// shares of half the depth and half the width that the body has behind the gills.
struct SideFin {
  double along, up, out;
  double length;  // as a share of FishForm::pectoral
  double down;    // radians that it points below straight back
  double spread;  // how far it stands off the body, as a share of its length
};

constexpr SideFin kPectoral{0.225, -0.25, 0.92, 1, 0.35, 0.55}, kPelvic{0.27, -0.93, 0.12, 0.75, 0.75, 0.25};

/// Adds it to a side, -1 or 1.
void add_side_fin(Surface& mesh, const FishForm& form, const SideFin& fin, double side) {
  constexpr double kBehindGills = 0.27;             // as a share of the body
  constexpr double kRootFan = 0.5, kFansOut = 0.9;  // radians between its edges, and how many more at its rim
  constexpr double kEdgesShorter = 0.35;            // than its middle, as a share of it
  double gill = fish_height(form, kBehindGills, -1), wide = fish_depth(form, kBehindGills) * form.width;
  double up = fin.up * gill, out = fin.out * wide, length = fin.length * form.pectoral;
  auto at = [=](double t, double r) {
    double fan = (t - 0.5) * (kRootFan + kFansOut * r),
           l = length * r * (1 - kEdgesShorter * std::pow(2 * t - 1, 2));
    return swimmer_place(fin.along + l * std::cos(fan + fin.down), up - l * std::sin(fan + fin.down),
                         side * (out + fin.spread * form.spread * l));
  };
  add_sheet(mesh, 8, 3, at, [](double t, double r) { return side_fin_uv(t, r); });
}

/// Those of a shark are stiff wings: swept back, tapered, held out and a little down; the hind ones small.
void add_wing(Surface& mesh, const FishForm& form, bool hind, double side) {
  constexpr double kRoot = 0.24, kHindRoot = 0.56;  // of the fish's length, from its nose
  constexpr double kChord = 0.5, kTaper = 0.8;      // of the span, at the root; by how much less at the tip
  constexpr double kSweep = 0.55, kDown = 0.45;     // of the span; radians below level
  constexpr double kHind = 0.42;                    // of the fore ones' span
  const double from = hind ? kHindRoot : kRoot, span = (hind ? kHind : 1) * form.pectoral;
  const double half = fish_height(form, from / kFishBody, -1), down = kDown * form.spread;
  auto at = [=](double t, double r) {
    // Its hind edge is hollow, its tip round.
    double chord = kChord * span * (1 - kTaper * std::pow(r, 0.8)) * std::sqrt(1 - 0.98 * std::pow(r, 8));
    return swimmer_place(from + kSweep * span * std::pow(r, 1.15) + chord * t,
                         -0.55 * half - span * r * std::sin(down),
                         side * (0.55 * half * form.width + span * r * std::cos(down)));
  };
  add_sheet(mesh, 5, 6, at, [](double t, double r) { return side_fin_uv(t, r); });
}

/// By how much less high a fin with spines is between two of them, at a share of its length.
double notch(double t) {
  constexpr double kDepth = 0.17, kFrom = 0.6, kTo = 0.68;  // where its soft part begins
  return kDepth * (0.5 - 0.5 * std::cos(2 * kPi * kSpines * t)) * (1 - smooth_step(kFrom, kTo, t));
}

void add_fins(Surface& mesh, const FishForm& form) {
  constexpr double kTailRoot = 0.9, kTailOpens = 0.8;  // of the body's depth; power of the way back
  constexpr double kTrails = 0.06;  // of the fish's length, by which a fin's hind corner lies behind its root
  // Where the fin of the belly begins and ends, as anal_height has it.
  constexpr double kAnalBegin = 0.52, kAnalEnd = 0.75;
  double root = 0.5 * form.depth * form.peduncle, begin = kFishBody - kTailOverlap;
  auto tail = [&](double t, double r) {
    double v = 2 * t - 1, reach = tail_reach(form.tail, v) * (1 - begin) * r;
    double up = v * (root * kTailRoot + (0.5 * form.tail_depth - root) * std::pow(r, kTailOpens));
    return std::pair(begin + reach, up);
  };
  auto tall = [&](double sign, double from, double to, double (*height)(const FishForm&, double)) {
    const bool notched = sign > 0 && form.dorsal_shape == DorsalShape::spiny;
    auto at = [=, &form](double t, double r) {
      double along = from + (to - from) * t, half = fish_height(form, along / kFishBody, sign);
      double high = height(form, along) * (1 - (notched ? notch(t) : 0));
      double lean = kTrails * r * smooth_step(0.3, 1.0, t) + form.sweep * high * r * r;
      // Its root is within the body.
      return std::pair(along + lean, sign * (0.93 * half + (0.07 * half + high) * r));
    };
    add_sheet(
        mesh, notched ? 4 * kSpines : kFinSteps, 2,
        [&](double t, double r) { return swimmer_place(at(t, r).first, at(t, r).second, 0); },
        [&](double t, double r) { return fish_uv(at(t, r).first, at(t, r).second); });
  };
  add_sheet(
      mesh, kFinSteps, 4,
      [&](double t, double r) { return swimmer_place(tail(t, r).first, tail(t, r).second, 0); },
      [&](double t, double r) { return fish_uv(tail(t, r).first, tail(t, r).second); });
  if (form.dorsal > 0) tall(1, form.dorsal_from, form.dorsal_to, dorsal_height);
  if (form.anal > 0) tall(-1, kAnalBegin, kAnalEnd, anal_height);
  if (form.pectoral <= 0) return;
  for (double side : {-1.0, 1.0}) {
    if (form.tail == TailShape::shark) {
      for (bool hind : {false, true}) add_wing(mesh, form, hind, side);
    } else {
      for (const SideFin& fin : {kPectoral, kPelvic}) add_side_fin(mesh, form, fin, side);
    }
  }
}

/// Bends the fish aside: a wave that runs down its body and grows toward the tail (Videler 1993), and a bow.
/// Lengths are shares of the fish's; it swings least a fifth behind its nose.
void bend_fish(Surface& mesh, double phase, double bend) {
  constexpr double kWaves = 0.95;                  // on its length at a time
  constexpr double kBow = 0.16, kBowMiddle = 0.3;  // coefficient of the parabola; its vertex from the nose
  for (Vec3& p : mesh.position) {
    double s = 0.5 - p.y;
    double swing = 0.012 - 0.055 * s + 0.125 * s * s;
    double wave = swing * std::sin(2 * kPi * (kWaves * s - phase));
    double bow = bend * kBow * (s - kBowMiddle) * (s - kBowMiddle);
    p.x += static_cast<float>(wave + bow);
  }
}

}  // namespace

void add_sheet(Surface& mesh, int columns, int rows, FunctionRef<Vec3(double, double)> place,
               FunctionRef<Vec2(double, double)> uv) {
  auto first = static_cast<std::uint32_t>(mesh.position.size());
  for (int i = 0; i <= columns; ++i)
    for (int j = 0; j <= rows; ++j) {
      double t = static_cast<double>(i) / columns, r = static_cast<double>(j) / rows;
      mesh.position.push_back(place(t, r));
      mesh.uv.push_back(uv(t, r));
    }
  auto wide = static_cast<std::uint32_t>(rows + 1);
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(columns); ++i)
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rows); ++j) {
      std::uint32_t a = first + i * wide + j;
      mesh.triangle.push_back({a, a + 1, a + wide});
      mesh.triangle.push_back({a + 1, a + wide + 1, a + wide});
    }
}

Surface fish_surface(const FishForm& form, double eye, double phase, double bend) {
  Surface mesh;
  add_body(mesh, form);
  add_eyes(mesh, form, eye);
  add_fins(mesh, form);
  bend_fish(mesh, phase, bend);
  set_normals(mesh);
  return mesh;
}

}  // namespace frond
