#include <algorithm>
#include <cmath>

#include "organisms/school/swimmer_shape.h"

namespace frond {

namespace {

/// How far the bell is contracted, 0 at rest .. 1: quickly together, slowly open again.
double contracted(double phase) {
  constexpr double kStroke = 0.3;  // share of the beat that contraction takes
  double t = phase - std::floor(phase);
  return t < kStroke ? smooth_step(0.0, kStroke, t) : 1 - smooth_step(kStroke, 1.0, t);
}

constexpr double kRimLag = 0.1;  // beats by which the rim is behind the top

void add_bell(Surface& mesh, double phase) {
  constexpr int kLappets = 32;
  auto place = [&](double t, double r) {
    double turn = 2 * kPi * r;
    Vec2 at = bell_profile(t, phase);
    double lappet = 1 + 0.022 * smooth_step(0.8, 1.0, t) * std::cos(kLappets * turn);
    double out = static_cast<double>(at.x) * lappet;
    return Vec3(static_cast<float>(out * std::cos(turn)), at.y, static_cast<float>(out * std::sin(turn)));
  };
  add_sheet(mesh, 20, 96, place, [](double t, double r) { return jelly_uv(JellyPart::bell, r, t); });
}

/// A frilled ribbon that trails from the middle of the bell.
void add_arm(Surface& mesh, double phase, int which, int count) {
  constexpr double kLong = 1.15, kWide = 0.17, kFrill = 0.045;
  double turn = 2 * kPi * which / count, lift = static_cast<double>(bell_profile(0, phase).y);
  Seed own = Seed{21}.child("arm", static_cast<std::uint64_t>(which));
  double length = kLong * own.child("length").range(0.75, 1.1), later = own.child("later").unit();
  auto place = [&](double t, double r) {
    double across = 2 * r - 1, wide = kWide * std::pow(1 - t, 0.6) * smooth_step(-0.15, 0.25, t);
    double sway = 0.10 * t * std::sin(2 * kPi * (0.9 * t - phase + later));
    double frill = kFrill * std::abs(across) * (1 - 0.6 * t) * std::sin(2 * kPi * (11 * t + 0.3 * across));
    double out = 0.05 + 0.04 * t + sway + frill,
           side = 0.5 * wide * across + 0.05 * t * std::sin(7 * t + 6 * later);
    return Vec3(static_cast<float>(out * std::cos(turn) - side * std::sin(turn)),
                static_cast<float>(lift - 0.14 - length * t),
                static_cast<float>(out * std::sin(turn) + side * std::cos(turn)));
  };
  add_sheet(mesh, 56, 5, place, [](double t, double r) { return jelly_uv(JellyPart::arm, r, t); });
}

/// A thread that trails from the rim.
void add_tentacle(Surface& mesh, double phase, int which, int count) {
  constexpr double kLong = 1.7, kThick = 0.006;
  Seed own = Seed{22}.child("tentacle", static_cast<std::uint64_t>(which));
  double turn = 2 * kPi * (which + own.child("turn").range(-0.3, 0.3)) / count,
         later = own.child("later").unit();
  double length = kLong * own.child("length").range(0.55, 1.1);
  Vec2 rim = bell_profile(1, phase);
  auto place = [&](double t, double r) {
    // What hangs keeps a little of the pulse of the rim, later the further it is.
    double drawn = 0.06 * t * (1 - t) * std::sin(2 * kPi * (phase - t));
    double sway = 0.09 * t * std::sin(2 * kPi * (1.1 * t - phase + later));
    double out = static_cast<double>(rim.x) * (1 - 0.35 * t) + drawn + sway,
           side = 0.07 * t * std::sin(2 * kPi * (0.7 * t - phase + 1.7 * later));
    double thick = kThick * (1 - 0.75 * t), round = 2 * kPi * r;
    out += thick * std::cos(round), side += thick * std::sin(round);
    return Vec3(static_cast<float>(out * std::cos(turn) - side * std::sin(turn)),
                rim.y - static_cast<float>(length * t),
                static_cast<float>(out * std::sin(turn) + side * std::cos(turn)));
  };
  add_sheet(mesh, 26, 3, place, [](double t, double r) { return jelly_uv(JellyPart::tentacle, r, t); });
}

}  // namespace

Vec2 bell_profile(double share, double phase) {
  constexpr double kOpen = 0.5, kShut = 0.34;   // half of its width
  constexpr double kFlat = 0.27, kHigh = 0.40;  // its height above the place where it is widest
  constexpr double kOver = 1.72;                // radians from its top to its rim
  double c = contracted(phase - kRimLag * share), angle = kOver * share;
  double wide = kOpen + (kShut - kOpen) * c, high = kFlat + (kHigh - kFlat) * c;
  // A flat top, and a rim that is drawn in as it contracts.
  double out = wide * std::pow(std::sin(std::min(angle, kPi / 2)), 0.85) *
               (1 - (0.03 + 0.12 * c) * smooth_step(0.75, 1.0, share));
  double up = high * std::cos(angle) - 0.06 * smooth_step(0.8, 1.0, share);
  return {static_cast<float>(out), static_cast<float>(up)};
}

Surface jellyfish_surface(double phase) {
  constexpr int kArms = 4, kTentacles = 24;
  Surface mesh;
  add_bell(mesh, phase);
  for (int i = 0; i < kArms; ++i) add_arm(mesh, phase, i, kArms);
  for (int i = 0; i < kTentacles; ++i) add_tentacle(mesh, phase, i, kTentacles);
  set_normals(mesh);
  return mesh;
}

}  // namespace frond
